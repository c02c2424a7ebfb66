// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_mul_uq10_9_uq1_8_to_uq10_11 (
    input  wire [18:0] a_i,  // UQ10.9
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [20:0] p_o  // UQ10.11
);

  wire [26:0] product = a_i * b_i;
  wire [26:0] sum = product + 27'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result

  assign p_o = sum[26:6];

endmodule

`default_nettype wire
