// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q8, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q8_mul_uq1_11_uq1_11_to_uq1_8 (
    input  wire [11:0] a_i,  // UQ1.11, codes 0..2048
    input  wire [11:0] b_i,  // UQ1.11, codes 0..2048
    output wire [8:0] p_o  // UQ1.8, codes 0..256
);

  wire [22:0] product = a_i * b_i;
  wire [22:0] sum = product + 23'd8192;
  wire [13:0] unused_sum_low = sum[13:0];  // below the last place of the result

  assign p_o = sum[22:14];

endmodule

`default_nettype wire
