// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_mul_uq1_19_uq1_19_to_uq1_16 (
    input  wire [19:0] a_i,  // UQ1.19, codes 0..524288
    input  wire [19:0] b_i,  // UQ1.19, codes 0..524288
    output wire [16:0] p_o  // UQ1.16, codes 0..65536
);

  wire [38:0] product = a_i * b_i;
  wire [38:0] sum = product + 39'd2097152;
  wire [21:0] unused_sum_low = sum[21:0];  // below the last place of the result

  assign p_o = sum[38:22];

endmodule

`default_nettype wire
