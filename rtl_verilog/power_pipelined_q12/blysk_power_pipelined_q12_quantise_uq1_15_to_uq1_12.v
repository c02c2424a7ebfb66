// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_quantise_uq1_15_to_uq1_12 (
    input  wire [15:0] a_i,  // UQ1.15
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  wire [15:0] sum = a_i + 16'd4;
  wire [2:0] unused_sum_low = sum[2:0];  // below the last place of the result

  assign y_o = sum[15:3];

endmodule

`default_nettype wire
