// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_quantise_uq6_28_to_uq1_9_clamp (
    input  wire [33:0] a_i,  // UQ6.28
    output wire [9:0] y_o  // UQ1.9, codes 0..512
);

  wire [34:0] sum = {1'b0, a_i} + 35'd262144;
  wire [18:0] unused_sum_low = sum[18:0];  // below the last place of the result
  wire [15:0] shifted = sum[34:19];

  assign y_o = (shifted[15:9] == 7'd0) ? shifted[9:0] : 10'd512;

endmodule

`default_nettype wire
