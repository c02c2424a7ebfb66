// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q24, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q24_mul_uq1_26_uq1_26_to_uq1_27 (
    input  wire [26:0] a_i,  // UQ1.26, codes 0..67108864
    input  wire [26:0] b_i,  // UQ1.26, codes 0..67108864
    output wire [27:0] p_o  // UQ1.27, codes 0..134217728
);

  wire [52:0] product = a_i * b_i;
  wire [52:0] sum = product + 53'd16777216;
  wire [24:0] unused_sum_low = sum[24:0];  // below the last place of the result

  assign p_o = sum[52:25];

endmodule

`default_nettype wire
