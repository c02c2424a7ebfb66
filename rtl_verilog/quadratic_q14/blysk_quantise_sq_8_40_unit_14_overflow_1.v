// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 40>, unit<14>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_40_unit_14_overflow_1 (
    input  wire signed [48:0] a_i,
    output wire [14:0] y_o
);

  wire [49:0] sum = {a_i[48], a_i} + 50'd33554432;
  wire [25:0] unused_sum_low = sum[25:0];  // below the last place of the result
  wire [23:0] shifted = sum[49:26];

  assign y_o = ($signed(shifted) < 24'sd0) ? 15'd0 : ($signed(shifted) > 24'sd16384) ? 15'd16384 : shifted[14:0];

endmodule

`default_nettype wire
