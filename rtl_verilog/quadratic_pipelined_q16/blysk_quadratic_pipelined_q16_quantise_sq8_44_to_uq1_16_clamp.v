// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_quantise_sq8_44_to_uq1_16_clamp (
    input  wire signed [52:0] a_i,  // SQ8.44
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  wire [53:0] sum = {a_i[52], a_i} + 54'd134217728;
  wire [27:0] unused_sum_low = sum[27:0];  // below the last place of the result
  wire [25:0] shifted = sum[53:28];

  assign y_o = shifted[25] ? 17'd0 : (shifted[25] || (shifted[24:16] == 9'd0)) ? shifted[16:0] : 17'd65536;

endmodule

`default_nettype wire
