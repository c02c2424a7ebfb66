// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_quantise_uq1_34_to_uq1_24 (
    input  wire [34:0] a_i,  // UQ1.34, codes 0..17179869184
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  wire [34:0] sum = a_i + 35'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result

  assign y_o = sum[34:10];

endmodule

`default_nettype wire
