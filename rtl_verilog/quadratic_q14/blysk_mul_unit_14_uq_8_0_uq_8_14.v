// SPDX-License-Identifier: Apache-2.0
// mul<unit<14>, uq<8, 0>, uq<8, 14>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_14_uq_8_0_uq_8_14 (
    input  wire [14:0] a_i,
    input  wire [7:0] b_i,
    output wire [21:0] p_o
);

  assign p_o = {7'b0, a_i} * {14'b0, b_i};

endmodule

`default_nettype wire
