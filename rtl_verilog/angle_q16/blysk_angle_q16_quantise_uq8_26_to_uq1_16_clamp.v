// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_quantise_uq8_26_to_uq1_16_clamp (
    input  wire [33:0] a_i,  // UQ8.26
    output wire [16:0] y_o  // UQ1.16
);

  wire [34:0] sum = {1'b0, a_i} + 35'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result
  wire [24:0] shifted = sum[34:10];

  assign y_o = (shifted < 25'd131071) ? shifted[16:0] : 17'd131071;

endmodule

`default_nettype wire
