// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device angle, format q12, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q12_quantise_uq8_22_to_uq1_16_clamp (
    input  wire [29:0] a_i,  // UQ8.22
    output wire [16:0] y_o  // UQ1.16
);

  wire [30:0] sum = {1'b0, a_i} + 31'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result
  wire [24:0] shifted = sum[30:6];

  assign y_o = (shifted < 25'd131071) ? shifted[16:0] : 17'd131071;

endmodule

`default_nettype wire
