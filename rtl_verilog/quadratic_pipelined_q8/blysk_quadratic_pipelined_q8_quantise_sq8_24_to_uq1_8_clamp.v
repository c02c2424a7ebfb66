// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_quantise_sq8_24_to_uq1_8_clamp (
    input  wire signed [32:0] a_i,  // SQ8.24
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  wire [33:0] sum = {a_i[32], a_i} + 34'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result
  wire [17:0] shifted = sum[33:16];

  assign y_o = shifted[17] ? 9'd0 : (shifted[17] || (shifted[16:8] == 9'd0)) ? shifted[8:0] : 9'd256;

endmodule

`default_nettype wire
