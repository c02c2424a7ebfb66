// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_quantise_uq1_26_to_uq1_12 (
    input  wire [26:0] a_i,  // UQ1.26, codes 0..67108864
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  wire [26:0] sum = a_i + 27'd8192;
  wire [13:0] unused_sum_low = sum[13:0];  // below the last place of the result

  assign y_o = sum[26:14];

endmodule

`default_nettype wire
