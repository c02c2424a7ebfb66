// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_quantise_uq1_11_to_uq1_8 (
    input  wire [11:0] a_i,  // UQ1.11
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  wire [11:0] sum = a_i + 12'd4;
  wire [2:0] unused_sum_low = sum[2:0];  // below the last place of the result

  assign y_o = sum[11:3];

endmodule

`default_nettype wire
