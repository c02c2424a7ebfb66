// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_mul_uq10_17_uq1_16_to_uq10_19 (
    input  wire [26:0] a_i,  // UQ10.17
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [28:0] p_o  // UQ10.19
);

  wire [42:0] product = a_i * b_i;
  wire [42:0] sum = product + 43'd8192;
  wire [13:0] unused_sum_low = sum[13:0];  // below the last place of the result

  assign p_o = sum[42:14];

endmodule

`default_nettype wire
