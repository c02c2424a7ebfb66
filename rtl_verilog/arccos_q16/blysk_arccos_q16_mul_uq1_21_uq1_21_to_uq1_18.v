// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device arccos, format q16, 22 digits of the root, table of 257 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q16_mul_uq1_21_uq1_21_to_uq1_18 (
    input  wire [21:0] a_i,  // UQ1.21
    input  wire [21:0] b_i,  // UQ1.21
    output wire [18:0] p_o  // UQ1.18
);

  wire [42:0] product = a_i * b_i;
  wire [42:0] sum = product + 43'd8388608;
  wire [23:0] unused_sum_low = sum[23:0];  // below the last place of the result

  assign p_o = sum[42:24];

endmodule

`default_nettype wire
