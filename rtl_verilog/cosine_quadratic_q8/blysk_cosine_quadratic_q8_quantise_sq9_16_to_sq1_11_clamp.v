// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_quantise_sq9_16_to_sq1_11_clamp (
    input  wire signed [25:0] a_i,  // SQ9.16
    output wire signed [12:0] y_o  // SQ1.11, codes -2048..2048
);

  wire [26:0] sum = {a_i[25], a_i} + 27'd16;
  wire [4:0] unused_sum_low = sum[4:0];  // below the last place of the result
  wire [21:0] shifted = sum[26:5];

  assign y_o = ($signed(shifted) < -22'sd2048) ? 13'd6144 : (shifted[21] || (shifted[20:11] == 10'd0)) ? shifted[12:0] : 13'd2048;

endmodule

`default_nettype wire
