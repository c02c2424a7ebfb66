// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 44>, unit<16>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_44_unit_16_overflow_1 (
    input  wire signed [52:0] a_i,
    output wire [16:0] y_o
);

  wire [53:0] sum = {a_i[52], a_i} + 54'd134217728;
  wire [27:0] unused_sum_low = sum[27:0];  // below the last place of the result
  wire [25:0] shifted = sum[53:28];

  assign y_o = ($signed(shifted) < 26'sd0) ? 17'd0 : ($signed(shifted) > 26'sd65536) ? 17'd65536 : shifted[16:0];

endmodule

`default_nettype wire
