// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_quantise_sq9_15_to_uq1_15_clamp (
    input  wire signed [24:0] a_i,  // SQ9.15
    output wire [15:0] y_o  // UQ1.15, codes 0..32768
);

  assign y_o = a_i[24] ? 16'd0 : (a_i[24] || (a_i[23:15] == 9'd0)) ? a_i[15:0] : 16'd32768;

endmodule

`default_nettype wire
