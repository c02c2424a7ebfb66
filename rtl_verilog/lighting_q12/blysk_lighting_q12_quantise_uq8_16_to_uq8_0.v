// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_quantise_uq8_16_to_uq8_0 (
    input  wire [23:0] a_i,  // UQ8.16, codes 0..16711680
    output wire [7:0] y_o  // UQ8.0
);

  wire [23:0] sum = a_i + 24'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result

  assign y_o = sum[23:16];

endmodule

`default_nettype wire
