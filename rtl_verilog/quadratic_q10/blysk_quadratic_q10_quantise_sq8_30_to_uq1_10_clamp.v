// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_quantise_sq8_30_to_uq1_10_clamp (
    input  wire signed [38:0] a_i,  // SQ8.30
    output wire [10:0] y_o  // UQ1.10, codes 0..1024
);

  wire [39:0] sum = {a_i[38], a_i} + 40'd524288;
  wire [19:0] unused_sum_low = sum[19:0];  // below the last place of the result
  wire [19:0] shifted = sum[39:20];

  assign y_o = ($signed(shifted) < 20'sd0) ? 11'd0 : ($signed(shifted) > 20'sd1024) ? 11'd1024 : shifted[10:0];

endmodule

`default_nettype wire
