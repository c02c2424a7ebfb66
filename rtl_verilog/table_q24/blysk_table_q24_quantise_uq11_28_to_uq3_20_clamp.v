// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_quantise_uq11_28_to_uq3_20_clamp (
    input  wire [38:0] a_i,  // UQ11.28
    output wire [22:0] y_o  // UQ3.20
);

  wire [39:0] sum = {1'b0, a_i} + 40'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result
  wire [31:0] shifted = sum[39:8];

  assign y_o = (shifted < 32'd8388607) ? shifted[22:0] : 23'd8388607;

endmodule

`default_nettype wire
