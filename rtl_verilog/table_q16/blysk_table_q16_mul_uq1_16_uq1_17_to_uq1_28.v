// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_mul_uq1_16_uq1_17_to_uq1_28 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire [17:0] b_i,  // UQ1.17
    output wire [28:0] p_o  // UQ1.28
);

  wire [33:0] product = a_i * b_i;
  wire [33:0] sum = product + 34'd16;
  wire [4:0] unused_sum_low = sum[4:0];  // below the last place of the result

  assign p_o = sum[33:5];

endmodule

`default_nettype wire
