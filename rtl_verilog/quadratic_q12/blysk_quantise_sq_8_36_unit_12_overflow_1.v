// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 36>, unit<12>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_36_unit_12_overflow_1 (
    input  wire signed [44:0] a_i,
    output wire [12:0] y_o
);

  wire [45:0] sum = {a_i[44], a_i} + 46'd8388608;
  wire [23:0] unused_sum_low = sum[23:0];  // below the last place of the result
  wire [21:0] shifted = sum[45:24];

  assign y_o = ($signed(shifted) < 22'sd0) ? 13'd0 : ($signed(shifted) > 22'sd4096) ? 13'd4096 : shifted[12:0];

endmodule

`default_nettype wire
