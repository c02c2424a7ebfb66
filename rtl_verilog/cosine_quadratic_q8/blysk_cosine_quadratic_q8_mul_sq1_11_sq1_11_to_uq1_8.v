// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_mul_sq1_11_sq1_11_to_uq1_8 (
    input  wire signed [12:0] a_i,  // SQ1.11, codes -2048..2048
    input  wire signed [12:0] b_i,  // SQ1.11, codes -2048..2048
    output wire [8:0] p_o  // UQ1.8, codes 0..256
);

  wire [22:0] product = a_i * b_i;
  wire [22:0] sum = product + 23'd8192;
  wire [13:0] unused_sum_low = sum[13:0];  // below the last place of the result

  assign p_o = sum[22:14];

endmodule

`default_nettype wire
