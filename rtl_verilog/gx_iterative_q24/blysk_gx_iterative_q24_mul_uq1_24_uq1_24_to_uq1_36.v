// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_mul_uq1_24_uq1_24_to_uq1_36 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [36:0] p_o  // UQ1.36, codes 0..68719476736
);

  wire [48:0] product = a_i * b_i;
  wire [48:0] sum = product + 49'd2048;
  wire [11:0] unused_sum_low = sum[11:0];  // below the last place of the result

  assign p_o = sum[48:12];

endmodule

`default_nettype wire
