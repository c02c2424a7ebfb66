// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device arccos, format q8, 14 digits of the root, table of 17 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q8_mul_uq1_13_uq1_13_to_uq1_10 (
    input  wire [13:0] a_i,  // UQ1.13
    input  wire [13:0] b_i,  // UQ1.13
    output wire [10:0] p_o  // UQ1.10
);

  wire [26:0] product = a_i * b_i;
  wire [26:0] sum = product + 27'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result

  assign p_o = sum[26:16];

endmodule

`default_nettype wire
