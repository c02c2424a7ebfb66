// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_quantise_sq8_52_to_uq1_20_clamp (
    input  wire signed [60:0] a_i,  // SQ8.52
    output wire [20:0] y_o  // UQ1.20, codes 0..1048576
);

  wire [61:0] sum = {a_i[60], a_i} + 62'd2147483648;
  wire [31:0] unused_sum_low = sum[31:0];  // below the last place of the result
  wire [29:0] shifted = sum[61:32];

  assign y_o = ($signed(shifted) < 30'sd0) ? 21'd0 : ($signed(shifted) > 30'sd1048576) ? 21'd1048576 : shifted[20:0];

endmodule

`default_nettype wire
