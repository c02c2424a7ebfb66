// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_quantise_sq8_40_to_uq1_14_clamp (
    input  wire signed [48:0] a_i,  // SQ8.40
    output wire [14:0] y_o  // UQ1.14, codes 0..16384
);

  wire [49:0] sum = {a_i[48], a_i} + 50'd33554432;
  wire [25:0] unused_sum_low = sum[25:0];  // below the last place of the result
  wire [23:0] shifted = sum[49:26];

  assign y_o = ($signed(shifted) < 24'sd0) ? 15'd0 : ($signed(shifted) > 24'sd16384) ? 15'd16384 : shifted[14:0];

endmodule

`default_nettype wire
