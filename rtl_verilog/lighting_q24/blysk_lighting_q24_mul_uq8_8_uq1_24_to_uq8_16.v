// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lighting, format q24, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q24_mul_uq8_8_uq1_24_to_uq8_16 (
    input  wire [15:0] a_i,  // UQ8.8, codes 0..65280
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [23:0] p_o  // UQ8.16, codes 0..16711680
);

  wire [39:0] product = a_i * b_i;
  wire [39:0] sum = product + 40'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result

  assign p_o = sum[39:16];

endmodule

`default_nettype wire
