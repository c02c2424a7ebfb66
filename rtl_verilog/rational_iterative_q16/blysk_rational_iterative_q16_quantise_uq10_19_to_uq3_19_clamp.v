// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_quantise_uq10_19_to_uq3_19_clamp (
    input  wire [28:0] a_i,  // UQ10.19
    output wire [21:0] y_o  // UQ3.19
);

  assign y_o = (a_i < 29'd4194303) ? a_i[21:0] : 22'd4194303;

endmodule

`default_nettype wire
