// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_mul_uq10_13_uq1_12_to_uq10_15 (
    input  wire [22:0] a_i,  // UQ10.13
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    output wire [24:0] p_o  // UQ10.15
);

  wire [34:0] product = a_i * b_i;
  wire [34:0] sum = product + 35'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result

  assign p_o = sum[34:10];

endmodule

`default_nettype wire
