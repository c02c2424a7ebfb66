// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q8, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q8_mul_uq1_10_uq1_10_to_uq1_11 (
    input  wire [10:0] a_i,  // UQ1.10, codes 0..1024
    input  wire [10:0] b_i,  // UQ1.10, codes 0..1024
    output wire [11:0] p_o  // UQ1.11, codes 0..2048
);

  wire [20:0] product = a_i * b_i;
  wire [20:0] sum = product + 21'd256;
  wire [8:0] unused_sum_low = sum[8:0];  // below the last place of the result

  assign p_o = sum[20:9];

endmodule

`default_nettype wire
