// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device angle, format q12, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q12_quantise_uq6_30_to_uq1_10_clamp (
    input  wire [35:0] a_i,  // UQ6.30
    output wire [10:0] y_o  // UQ1.10, codes 0..1024
);

  wire [36:0] sum = {1'b0, a_i} + 37'd524288;
  wire [19:0] unused_sum_low = sum[19:0];  // below the last place of the result
  wire [16:0] shifted = sum[36:20];

  assign y_o = (shifted[16:10] == 7'd0) ? shifted[10:0] : 11'd1024;

endmodule

`default_nettype wire
