// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device arccos, format q12, 18 digits of the root, table of 65 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q12_mul_uq1_17_uq1_17_to_uq1_14 (
    input  wire [17:0] a_i,  // UQ1.17
    input  wire [17:0] b_i,  // UQ1.17
    output wire [14:0] p_o  // UQ1.14
);

  wire [34:0] product = a_i * b_i;
  wire [34:0] sum = product + 35'd524288;
  wire [19:0] unused_sum_low = sum[19:0];  // below the last place of the result

  assign p_o = sum[34:20];

endmodule

`default_nettype wire
