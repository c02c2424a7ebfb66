// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_mul_uq1_14_uq1_14_to_uq1_26 (
    input  wire [14:0] a_i,  // UQ1.14, codes 0..16384
    input  wire [14:0] b_i,  // UQ1.14, codes 0..16384
    output wire [26:0] p_o  // UQ1.26
);

  wire [28:0] sum = {14'b0, a_i} * {14'b0, b_i} + 29'd2;
  wire [1:0] unused_sum_low = sum[1:0];  // below the last place of the result

  assign p_o = sum[28:2];

endmodule

`default_nettype wire
