// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_mul_uq1_20_uq1_20_to_uq1_32 (
    input  wire [20:0] a_i,  // UQ1.20, codes 0..1048576
    input  wire [20:0] b_i,  // UQ1.20, codes 0..1048576
    output wire [32:0] p_o  // UQ1.32
);

  wire [40:0] sum = {20'b0, a_i} * {20'b0, b_i} + 41'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result

  assign p_o = sum[40:8];

endmodule

`default_nettype wire
