// SPDX-License-Identifier: Apache-2.0
// mul<unit<18>, uq<8, 0>, uq<8, 18>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_18_uq_8_0_uq_8_18 (
    input  wire [18:0] a_i,
    input  wire [7:0] b_i,
    output wire [25:0] p_o
);

  assign p_o = {7'b0, a_i} * {18'b0, b_i};

endmodule

`default_nettype wire
