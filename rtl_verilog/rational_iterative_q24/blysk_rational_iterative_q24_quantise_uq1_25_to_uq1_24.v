// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_quantise_uq1_25_to_uq1_24 (
    input  wire [25:0] a_i,  // UQ1.25, codes 0..33554432
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  wire [25:0] sum = a_i + 26'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result

  assign y_o = sum[25:1];

endmodule

`default_nettype wire
