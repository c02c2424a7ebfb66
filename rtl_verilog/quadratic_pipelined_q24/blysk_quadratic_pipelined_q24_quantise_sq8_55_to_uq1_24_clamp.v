// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_quantise_sq8_55_to_uq1_24_clamp (
    input  wire signed [63:0] a_i,  // SQ8.55
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  wire [29:0] unused_a_i_low = a_i[29:0];  // below the last place of the result
  wire [33:0] shifted = a_i[63:30];
  wire [34:0] sum = {shifted[33], shifted} + 35'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result
  wire [33:0] shifted2 = sum[34:1];

  assign y_o = shifted2[33] ? 25'd0 : (shifted2[33] || (shifted2[32:24] == 9'd0)) ? shifted2[24:0] : 25'd16777216;

endmodule

`default_nettype wire
