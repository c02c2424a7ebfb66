// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_one_minus_uq1_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  assign y_o = 9'd256 - a_i;

endmodule

`default_nettype wire
