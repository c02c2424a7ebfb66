// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_quantise_uq1_19_to_uq1_16 (
    input  wire [19:0] a_i,  // UQ1.19
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  wire [19:0] sum = a_i + 20'd4;
  wire [2:0] unused_sum_low = sum[2:0];  // below the last place of the result

  assign y_o = sum[19:3];

endmodule

`default_nettype wire
