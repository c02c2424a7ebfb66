// SPDX-License-Identifier: Apache-2.0
// mul<unit<10>, uq<8, 0>, uq<8, 10>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_10_uq_8_0_uq_8_10 (
    input  wire [10:0] a_i,
    input  wire [7:0] b_i,
    output wire [17:0] p_o
);

  assign p_o = {7'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
