// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device arccos, format q24, 30 digits of the root, table of 4097 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q24_mul_uq1_29_uq1_29_to_uq1_26 (
    input  wire [29:0] a_i,  // UQ1.29
    input  wire [29:0] b_i,  // UQ1.29
    output wire [26:0] p_o  // UQ1.26
);

  wire [58:0] product = a_i * b_i;
  wire [58:0] sum = product + 59'd2147483648;
  wire [31:0] unused_sum_low = sum[31:0];  // below the last place of the result

  assign p_o = sum[58:32];

endmodule

`default_nettype wire
