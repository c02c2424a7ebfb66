// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_quantise_uq11_24_to_uq3_16_clamp (
    input  wire [34:0] a_i,  // UQ11.24
    output wire [18:0] y_o  // UQ3.16
);

  wire [35:0] sum = {1'b0, a_i} + 36'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result
  wire [27:0] shifted = sum[35:8];

  assign y_o = (shifted < 28'd524287) ? shifted[18:0] : 19'd524287;

endmodule

`default_nettype wire
