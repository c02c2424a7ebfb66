// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_mul_uq1_24_uq1_25_to_uq1_28 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [25:0] b_i,  // UQ1.25
    output wire [28:0] p_o  // UQ1.28
);

  wire [49:0] product = a_i * b_i;
  wire [49:0] sum = product + 50'd1048576;
  wire [20:0] unused_sum_low = sum[20:0];  // below the last place of the result

  assign p_o = sum[49:21];

endmodule

`default_nettype wire
