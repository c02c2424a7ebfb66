// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_quantise_uq1_18_to_uq1_8 (
    input  wire [18:0] a_i,  // UQ1.18, codes 0..262144
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  wire [18:0] sum = a_i + 19'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result

  assign y_o = sum[18:10];

endmodule

`default_nettype wire
