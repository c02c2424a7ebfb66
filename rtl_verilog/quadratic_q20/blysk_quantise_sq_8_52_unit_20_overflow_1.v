// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 52>, unit<20>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_52_unit_20_overflow_1 (
    input  wire signed [60:0] a_i,
    output wire [20:0] y_o
);

  wire [61:0] sum = {a_i[60], a_i} + 62'd2147483648;
  wire [31:0] unused_sum_low = sum[31:0];  // below the last place of the result
  wire [29:0] shifted = sum[61:32];

  assign y_o = ($signed(shifted) < 30'sd0) ? 21'd0 : ($signed(shifted) > 30'sd1048576) ? 21'd1048576 : shifted[20:0];

endmodule

`default_nettype wire
