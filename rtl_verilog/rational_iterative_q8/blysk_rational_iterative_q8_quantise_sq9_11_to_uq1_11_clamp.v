// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_quantise_sq9_11_to_uq1_11_clamp (
    input  wire signed [20:0] a_i,  // SQ9.11
    output wire [11:0] y_o  // UQ1.11, codes 0..2048
);

  assign y_o = a_i[20] ? 12'd0 : (a_i[20] || (a_i[19:11] == 9'd0)) ? a_i[11:0] : 12'd2048;

endmodule

`default_nettype wire
