// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_one_minus_uq1_16 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  assign y_o = 17'd65536 - a_i;

endmodule

`default_nettype wire
