// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_quantise_sq8_36_to_uq1_12_clamp (
    input  wire signed [44:0] a_i,  // SQ8.36
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  wire [45:0] sum = {a_i[44], a_i} + 46'd8388608;
  wire [23:0] unused_sum_low = sum[23:0];  // below the last place of the result
  wire [21:0] shifted = sum[45:24];

  assign y_o = shifted[21] ? 13'd0 : (shifted[21] || (shifted[20:12] == 9'd0)) ? shifted[12:0] : 13'd4096;

endmodule

`default_nettype wire
