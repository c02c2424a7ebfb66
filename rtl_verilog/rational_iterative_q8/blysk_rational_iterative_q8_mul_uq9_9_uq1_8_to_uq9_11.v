// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_mul_uq9_9_uq1_8_to_uq9_11 (
    input  wire [17:0] a_i,  // UQ9.9
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [19:0] p_o  // UQ9.11
);

  wire [25:0] product = a_i * b_i;
  wire [25:0] sum = product + 26'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result

  assign p_o = sum[25:6];

endmodule

`default_nettype wire
