// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_mul_uq1_24_uq1_24_to_uq1_35 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [35:0] p_o  // UQ1.35
);

  wire [48:0] product = a_i * b_i;
  wire [48:0] sum = product + 49'd4096;
  wire [12:0] unused_sum_low = sum[12:0];  // below the last place of the result

  assign p_o = sum[48:13];

endmodule

`default_nettype wire
