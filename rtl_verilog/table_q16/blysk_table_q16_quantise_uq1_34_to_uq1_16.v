// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_quantise_uq1_34_to_uq1_16 (
    input  wire [34:0] a_i,  // UQ1.34, codes 0..17179869184
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  wire [34:0] sum = a_i + 35'd131072;
  wire [17:0] unused_sum_low = sum[17:0];  // below the last place of the result

  assign y_o = sum[34:18];

endmodule

`default_nettype wire
