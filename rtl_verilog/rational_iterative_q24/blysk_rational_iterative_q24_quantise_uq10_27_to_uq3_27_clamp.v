// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_quantise_uq10_27_to_uq3_27_clamp (
    input  wire [36:0] a_i,  // UQ10.27
    output wire [29:0] y_o  // UQ3.27
);

  assign y_o = (a_i < 37'd1073741823) ? a_i[29:0] : 30'd1073741823;

endmodule

`default_nettype wire
