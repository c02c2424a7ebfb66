// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_mul_uq9_25_uq1_24_to_uq9_27 (
    input  wire [33:0] a_i,  // UQ9.25
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [35:0] p_o  // UQ9.27
);

  wire [57:0] product = a_i * b_i;
  wire [57:0] sum = product + 58'd2097152;
  wire [21:0] unused_sum_low = sum[21:0];  // below the last place of the result

  assign p_o = sum[57:22];

endmodule

`default_nettype wire
