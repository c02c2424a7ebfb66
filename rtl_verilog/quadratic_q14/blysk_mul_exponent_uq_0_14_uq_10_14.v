// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 14>, uq<10, 14>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_14_uq_10_14 (
    input  wire [9:0] a_i,
    input  wire [13:0] b_i,
    output wire [23:0] p_o
);

  assign p_o = {14'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
