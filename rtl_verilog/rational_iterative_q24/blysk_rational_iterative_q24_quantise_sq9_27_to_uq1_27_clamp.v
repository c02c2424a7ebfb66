// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_quantise_sq9_27_to_uq1_27_clamp (
    input  wire signed [36:0] a_i,  // SQ9.27
    output wire [27:0] y_o  // UQ1.27, codes 0..134217728
);

  assign y_o = a_i[36] ? 28'd0 : (a_i[36] || (a_i[35:27] == 9'd0)) ? a_i[27:0] : 28'd134217728;

endmodule

`default_nettype wire
