// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q24, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q24_quantise_sq8_55_to_uq1_24_clamp (
    input  wire signed [63:0] a_i,  // SQ8.55
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  wire [64:0] sum = {a_i[63], a_i} + 65'd1073741824;
  wire [30:0] unused_sum_low = sum[30:0];  // below the last place of the result
  wire [33:0] shifted = sum[64:31];

  assign y_o = ($signed(shifted) < 34'sd0) ? 25'd0 : ($signed(shifted) > 34'sd16777216) ? 25'd16777216 : shifted[24:0];

endmodule

`default_nettype wire
