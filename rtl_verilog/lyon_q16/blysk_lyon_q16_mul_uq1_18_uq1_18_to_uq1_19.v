// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_mul_uq1_18_uq1_18_to_uq1_19 (
    input  wire [18:0] a_i,  // UQ1.18, codes 0..262144
    input  wire [18:0] b_i,  // UQ1.18, codes 0..262144
    output wire [19:0] p_o  // UQ1.19, codes 0..524288
);

  wire [36:0] product = a_i * b_i;
  wire [36:0] sum = product + 37'd65536;
  wire [16:0] unused_sum_low = sum[16:0];  // below the last place of the result

  assign p_o = sum[36:17];

endmodule

`default_nettype wire
