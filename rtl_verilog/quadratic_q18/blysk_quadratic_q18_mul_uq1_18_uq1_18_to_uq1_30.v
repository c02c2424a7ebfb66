// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_mul_uq1_18_uq1_18_to_uq1_30 (
    input  wire [18:0] a_i,  // UQ1.18, codes 0..262144
    input  wire [18:0] b_i,  // UQ1.18, codes 0..262144
    output wire [30:0] p_o  // UQ1.30
);

  wire [36:0] sum = {18'b0, a_i} * {18'b0, b_i} + 37'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result

  assign p_o = sum[36:6];

endmodule

`default_nettype wire
