// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_mul_sq1_27_sq1_27_to_uq1_24 (
    input  wire signed [28:0] a_i,  // SQ1.27, codes -134217728..134217728
    input  wire signed [28:0] b_i,  // SQ1.27, codes -134217728..134217728
    output wire [24:0] p_o  // UQ1.24, codes 0..16777216
);

  wire [54:0] product = a_i * b_i;
  wire [54:0] sum = product + 55'd536870912;
  wire [29:0] unused_sum_low = sum[29:0];  // below the last place of the result

  assign p_o = sum[54:30];

endmodule

`default_nettype wire
