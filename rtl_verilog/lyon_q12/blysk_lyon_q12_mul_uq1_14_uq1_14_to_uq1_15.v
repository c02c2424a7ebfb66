// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q12, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q12_mul_uq1_14_uq1_14_to_uq1_15 (
    input  wire [14:0] a_i,  // UQ1.14, codes 0..16384
    input  wire [14:0] b_i,  // UQ1.14, codes 0..16384
    output wire [15:0] p_o  // UQ1.15, codes 0..32768
);

  wire [28:0] product = a_i * b_i;
  wire [28:0] sum = product + 29'd4096;
  wire [12:0] unused_sum_low = sum[12:0];  // below the last place of the result

  assign p_o = sum[28:13];

endmodule

`default_nettype wire
