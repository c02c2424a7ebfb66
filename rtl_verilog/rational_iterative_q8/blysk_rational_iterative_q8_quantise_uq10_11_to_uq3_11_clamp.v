// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_quantise_uq10_11_to_uq3_11_clamp (
    input  wire [20:0] a_i,  // UQ10.11
    output wire [13:0] y_o  // UQ3.11
);

  assign y_o = (a_i < 21'd16383) ? a_i[13:0] : 14'd16383;

endmodule

`default_nettype wire
