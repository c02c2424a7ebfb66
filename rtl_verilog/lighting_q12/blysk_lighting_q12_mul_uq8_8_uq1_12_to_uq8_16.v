// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_mul_uq8_8_uq1_12_to_uq8_16 (
    input  wire [15:0] a_i,  // UQ8.8, codes 0..65280
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    output wire [23:0] p_o  // UQ8.16, codes 0..16711680
);

  wire [27:0] product = a_i * b_i;
  wire [27:0] sum = product + 28'd8;
  wire [3:0] unused_sum_low = sum[3:0];  // below the last place of the result

  assign p_o = sum[27:4];

endmodule

`default_nettype wire
