// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q12, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q12_mul_uq1_15_uq1_15_to_uq1_12 (
    input  wire [15:0] a_i,  // UQ1.15, codes 0..32768
    input  wire [15:0] b_i,  // UQ1.15, codes 0..32768
    output wire [12:0] p_o  // UQ1.12, codes 0..4096
);

  wire [30:0] product = a_i * b_i;
  wire [30:0] sum = product + 31'd131072;
  wire [17:0] unused_sum_low = sum[17:0];  // below the last place of the result

  assign p_o = sum[30:18];

endmodule

`default_nettype wire
