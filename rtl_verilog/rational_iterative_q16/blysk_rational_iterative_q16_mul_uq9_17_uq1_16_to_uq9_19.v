// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_mul_uq9_17_uq1_16_to_uq9_19 (
    input  wire [25:0] a_i,  // UQ9.17
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [27:0] p_o  // UQ9.19
);

  wire [41:0] product = a_i * b_i;
  wire [41:0] sum = product + 42'd8192;
  wire [13:0] unused_sum_low = sum[13:0];  // below the last place of the result

  assign p_o = sum[41:14];

endmodule

`default_nettype wire
