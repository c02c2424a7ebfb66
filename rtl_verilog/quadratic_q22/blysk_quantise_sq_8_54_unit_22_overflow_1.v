// SPDX-License-Identifier: Apache-2.0
// quantise<sq<8, 54>, unit<22>, (overflow)1>, exported from the SystemC model.
`default_nettype none

module blysk_quantise_sq_8_54_unit_22_overflow_1 (
    input  wire signed [62:0] a_i,
    output wire [22:0] y_o
);

  wire [63:0] sum = {a_i[62], a_i} + 64'd2147483648;
  wire [31:0] unused_sum_low = sum[31:0];  // below the last place of the result
  wire [31:0] shifted = sum[63:32];

  assign y_o = ($signed(shifted) < 32'sd0) ? 23'd0 : ($signed(shifted) > 32'sd4194304) ? 23'd4194304 : shifted[22:0];

endmodule

`default_nettype wire
