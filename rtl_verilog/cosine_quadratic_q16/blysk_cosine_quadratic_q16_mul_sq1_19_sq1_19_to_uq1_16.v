// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device cosine-quadratic, format q16, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q16_mul_sq1_19_sq1_19_to_uq1_16 (
    input  wire signed [20:0] a_i,  // SQ1.19, codes -524288..524288
    input  wire signed [20:0] b_i,  // SQ1.19, codes -524288..524288
    output wire [16:0] p_o  // UQ1.16, codes 0..65536
);

  wire [38:0] product = a_i * b_i;
  wire [38:0] sum = product + 39'd2097152;
  wire [21:0] unused_sum_low = sum[21:0];  // below the last place of the result

  assign p_o = sum[38:22];

endmodule

`default_nettype wire
