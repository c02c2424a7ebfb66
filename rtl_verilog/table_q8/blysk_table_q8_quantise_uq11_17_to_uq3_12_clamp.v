// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_quantise_uq11_17_to_uq3_12_clamp (
    input  wire [27:0] a_i,  // UQ11.17
    output wire [14:0] y_o  // UQ3.12
);

  wire [28:0] sum = {1'b0, a_i} + 29'd16;
  wire [4:0] unused_sum_low = sum[4:0];  // below the last place of the result
  wire [23:0] shifted = sum[28:5];

  assign y_o = (shifted < 24'd32767) ? shifted[14:0] : 15'd32767;

endmodule

`default_nettype wire
