// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_quantise_sq9_48_to_sq1_27_clamp (
    input  wire signed [57:0] a_i,  // SQ9.48
    output wire signed [28:0] y_o  // SQ1.27, codes -134217728..134217728
);

  wire [58:0] sum = {a_i[57], a_i} + 59'd1048576;
  wire [20:0] unused_sum_low = sum[20:0];  // below the last place of the result
  wire [37:0] shifted = sum[58:21];

  assign y_o = ($signed(shifted) < -38'sd134217728) ? 29'd402653184 : (shifted[37] || (shifted[36:27] == 10'd0)) ? shifted[28:0] : 29'd134217728;

endmodule

`default_nettype wire
