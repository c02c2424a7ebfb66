// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_quantise_uq8_18_to_uq1_15_clamp (
    input  wire [25:0] a_i,  // UQ8.18
    output wire [15:0] y_o  // UQ1.15
);

  wire [26:0] sum = {1'b0, a_i} + 27'd4;
  wire [2:0] unused_sum_low = sum[2:0];  // below the last place of the result
  wire [23:0] shifted = sum[26:3];

  assign y_o = (shifted < 24'd65535) ? shifted[15:0] : 16'd65535;

endmodule

`default_nettype wire
