// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_quantise_uq10_15_to_uq3_15_clamp (
    input  wire [24:0] a_i,  // UQ10.15
    output wire [17:0] y_o  // UQ3.15
);

  assign y_o = (a_i < 25'd262143) ? a_i[17:0] : 18'd262143;

endmodule

`default_nettype wire
