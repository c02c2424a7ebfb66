// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_one_minus_uq1_12 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  assign y_o = 13'd4096 - a_i;

endmodule

`default_nettype wire
