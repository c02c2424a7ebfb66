// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device cosine-quadratic, format q16, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q16_quantise_sq9_32_to_sq1_19_clamp (
    input  wire signed [41:0] a_i,  // SQ9.32
    output wire signed [20:0] y_o  // SQ1.19, codes -524288..524288
);

  wire [42:0] sum = {a_i[41], a_i} + 43'd4096;
  wire [12:0] unused_sum_low = sum[12:0];  // below the last place of the result
  wire [29:0] shifted = sum[42:13];

  assign y_o = ($signed(shifted) < -30'sd524288) ? 21'd1572864 : (shifted[29] || (shifted[28:19] == 10'd0)) ? shifted[20:0] : 21'd524288;

endmodule

`default_nettype wire
