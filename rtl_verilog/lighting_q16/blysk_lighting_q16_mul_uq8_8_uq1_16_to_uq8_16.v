// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lighting, format q16, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q16_mul_uq8_8_uq1_16_to_uq8_16 (
    input  wire [15:0] a_i,  // UQ8.8, codes 0..65280
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [23:0] p_o  // UQ8.16, codes 0..16711680
);

  wire [31:0] product = a_i * b_i;
  wire [31:0] sum = product + 32'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result

  assign p_o = sum[31:8];

endmodule

`default_nettype wire
