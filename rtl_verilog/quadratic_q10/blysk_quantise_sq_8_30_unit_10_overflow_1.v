// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 30>, unit<10>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_30_unit_10_overflow_1 (
    input  wire signed [38:0] a_i,
    output wire [10:0] y_o
);

  wire [39:0] sum = {a_i[38], a_i} + 40'd524288;
  wire [19:0] unused_sum_low = sum[19:0];  // below the last place of the result
  wire [19:0] shifted = sum[39:20];

  assign y_o = ($signed(shifted) < 20'sd0) ? 11'd0 : ($signed(shifted) > 20'sd1024) ? 11'd1024 : shifted[10:0];

endmodule

`default_nettype wire
