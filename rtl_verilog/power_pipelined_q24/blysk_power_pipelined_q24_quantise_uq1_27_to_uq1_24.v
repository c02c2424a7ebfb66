// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_quantise_uq1_27_to_uq1_24 (
    input  wire [27:0] a_i,  // UQ1.27
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  wire [27:0] sum = a_i + 28'd4;
  wire [2:0] unused_sum_low = sum[2:0];  // below the last place of the result

  assign y_o = sum[27:3];

endmodule

`default_nettype wire
