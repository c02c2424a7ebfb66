// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 24>, unit<8>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_24_unit_8_overflow_1 (
    input  wire signed [32:0] a_i,
    output wire [8:0] y_o
);

  wire [33:0] sum = {a_i[32], a_i} + 34'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result
  wire [17:0] shifted = sum[33:16];

  assign y_o = ($signed(shifted) < 18'sd0) ? 9'd0 : ($signed(shifted) > 18'sd256) ? 9'd256 : shifted[8:0];

endmodule

`default_nettype wire
