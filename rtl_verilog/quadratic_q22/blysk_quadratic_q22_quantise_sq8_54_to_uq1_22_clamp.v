// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_quantise_sq8_54_to_uq1_22_clamp (
    input  wire signed [62:0] a_i,  // SQ8.54
    output wire [22:0] y_o  // UQ1.22, codes 0..4194304
);

  wire [63:0] sum = {a_i[62], a_i} + 64'd2147483648;
  wire [31:0] unused_sum_low = sum[31:0];  // below the last place of the result
  wire [31:0] shifted = sum[63:32];

  assign y_o = ($signed(shifted) < 32'sd0) ? 23'd0 : ($signed(shifted) > 32'sd4194304) ? 23'd4194304 : shifted[22:0];

endmodule

`default_nettype wire
