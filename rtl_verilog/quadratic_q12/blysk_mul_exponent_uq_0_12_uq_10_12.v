// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 12>, uq<10, 12>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_12_uq_10_12 (
    input  wire [9:0] a_i,
    input  wire [11:0] b_i,
    output wire [21:0] p_o
);

  assign p_o = {12'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
