// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device cosine-quadratic, format q12, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q12_quantise_sq9_24_to_sq1_15_clamp (
    input  wire signed [33:0] a_i,  // SQ9.24
    output wire signed [16:0] y_o  // SQ1.15, codes -32768..32768
);

  wire [34:0] sum = {a_i[33], a_i} + 35'd256;
  wire [8:0] unused_sum_low = sum[8:0];  // below the last place of the result
  wire [25:0] shifted = sum[34:9];

  assign y_o = ($signed(shifted) < -26'sd32768) ? 17'd98304 : (shifted[25] || (shifted[24:15] == 10'd0)) ? shifted[16:0] : 17'd32768;

endmodule

`default_nettype wire
