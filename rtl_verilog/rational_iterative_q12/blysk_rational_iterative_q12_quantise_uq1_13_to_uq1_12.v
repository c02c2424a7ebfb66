// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_quantise_uq1_13_to_uq1_12 (
    input  wire [13:0] a_i,  // UQ1.13, codes 0..8192
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  wire [13:0] sum = a_i + 14'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result

  assign y_o = sum[13:1];

endmodule

`default_nettype wire
