// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_one_minus_uq1_24 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  assign y_o = 25'd16777216 - a_i;

endmodule

`default_nettype wire
