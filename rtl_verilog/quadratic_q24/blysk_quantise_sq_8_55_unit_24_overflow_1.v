// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 55>, unit<24>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_55_unit_24_overflow_1 (
    input  wire signed [63:0] a_i,
    output wire [24:0] y_o
);

  wire [64:0] sum = {a_i[63], a_i} + 65'd1073741824;
  wire [30:0] unused_sum_low = sum[30:0];  // below the last place of the result
  wire [33:0] shifted = sum[64:31];

  assign y_o = ($signed(shifted) < 34'sd0) ? 25'd0 : ($signed(shifted) > 34'sd16777216) ? 25'd16777216 : shifted[24:0];

endmodule

`default_nettype wire
