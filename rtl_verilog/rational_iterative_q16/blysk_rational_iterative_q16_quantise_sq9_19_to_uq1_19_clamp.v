// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_quantise_sq9_19_to_uq1_19_clamp (
    input  wire signed [28:0] a_i,  // SQ9.19
    output wire [19:0] y_o  // UQ1.19, codes 0..524288
);

  assign y_o = a_i[28] ? 20'd0 : (a_i[28] || (a_i[27:19] == 9'd0)) ? a_i[19:0] : 20'd524288;

endmodule

`default_nettype wire
