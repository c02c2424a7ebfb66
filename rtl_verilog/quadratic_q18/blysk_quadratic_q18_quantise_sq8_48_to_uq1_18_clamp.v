// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_quantise_sq8_48_to_uq1_18_clamp (
    input  wire signed [56:0] a_i,  // SQ8.48
    output wire [18:0] y_o  // UQ1.18, codes 0..262144
);

  wire [57:0] sum = {a_i[56], a_i} + 58'd536870912;
  wire [29:0] unused_sum_low = sum[29:0];  // below the last place of the result
  wire [27:0] shifted = sum[57:30];

  assign y_o = ($signed(shifted) < 28'sd0) ? 19'd0 : ($signed(shifted) > 28'sd262144) ? 19'd262144 : shifted[18:0];

endmodule

`default_nettype wire
