// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_mul_uq1_12_uq1_13_to_uq1_24 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    input  wire [13:0] b_i,  // UQ1.13
    output wire [24:0] p_o  // UQ1.24
);

  wire [25:0] product = a_i * b_i;
  wire [25:0] sum = product + 26'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result

  assign p_o = sum[25:1];

endmodule

`default_nettype wire
