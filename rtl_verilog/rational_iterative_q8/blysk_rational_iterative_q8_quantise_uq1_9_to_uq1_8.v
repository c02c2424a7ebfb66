// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_quantise_uq1_9_to_uq1_8 (
    input  wire [9:0] a_i,  // UQ1.9, codes 0..512
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  wire [9:0] sum = a_i + 10'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result

  assign y_o = sum[9:1];

endmodule

`default_nettype wire
