// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 48>, unit<18>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_48_unit_18_overflow_1 (
    input  wire signed [56:0] a_i,
    output wire [18:0] y_o
);

  wire [57:0] sum = {a_i[56], a_i} + 58'd536870912;
  wire [29:0] unused_sum_low = sum[29:0];  // below the last place of the result
  wire [27:0] shifted = sum[57:30];

  assign y_o = ($signed(shifted) < 28'sd0) ? 19'd0 : ($signed(shifted) > 28'sd262144) ? 19'd262144 : shifted[18:0];

endmodule

`default_nettype wire
