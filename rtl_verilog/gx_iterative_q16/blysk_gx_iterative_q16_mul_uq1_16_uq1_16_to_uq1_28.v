// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device gx-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q16_mul_uq1_16_uq1_16_to_uq1_28 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [28:0] p_o  // UQ1.28, codes 0..268435456
);

  wire [32:0] product = a_i * b_i;
  wire [32:0] sum = product + 33'd8;
  wire [3:0] unused_sum_low = sum[3:0];  // below the last place of the result

  assign p_o = sum[32:4];

endmodule

`default_nettype wire
