// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_mul_uq1_22_uq1_22_to_uq1_34 (
    input  wire [22:0] a_i,  // UQ1.22, codes 0..4194304
    input  wire [22:0] b_i,  // UQ1.22, codes 0..4194304
    output wire [34:0] p_o  // UQ1.34
);

  wire [44:0] sum = {22'b0, a_i} * {22'b0, b_i} + 45'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result

  assign p_o = sum[44:10];

endmodule

`default_nettype wire
