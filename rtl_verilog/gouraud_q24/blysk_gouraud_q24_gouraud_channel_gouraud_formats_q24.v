// SPDX-License-Identifier: Apache-2.0
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_gouraud_channel_gouraud_formats_q24 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire draw_i,
    input  wire digit_i,
    input  wire one_i,
    input  wire ground_i,
    input  wire [7:0] left_i,  // UQ8.0
    input  wire [7:0] right_i,  // UQ8.0
    output wire [7:0] pixel_o  // UQ8.0
);

  wire signed [31:0] shifted;  // rg_shift: SQ7.24
  wire signed [32:0] increment;  // rg_sum: SQ8.24
  wire signed [34:0] intensity;  // rg_pixel: SQ10.24
  wire signed [8:0] inverted;  // inv_left: SQ8.0
  wire signed [8:0] difference;  // add_difference: SQ8.0, codes -255..255
  wire signed [32:0] sum;  // add_sum: SQ8.24
  wire signed [34:0] next;  // add_pixel: SQ10.24

  blysk_gouraud_q24_shift_register_sq8_0_to_sq7_24 rg_shift (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(step_i), .d_i(difference), .q_o(shifted)
  );
  blysk_gouraud_q24_sum_register_sq8_0_sq8_24_to_sq8_24 rg_sum (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(step_i), .add_i(digit_i), .d_i(difference), .sum_i(sum), .q_o(increment)
  );
  blysk_gouraud_q24_start_register_uq8_0_sq10_24_to_sq10_24 rg_pixel (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(left_i), .sum_i(next), .q_o(intensity)
  );
  blysk_gouraud_q24_inverter_bank_uq8_0_to_sq8_0 inv_left (.a_i(left_i), .y_o(inverted));
  blysk_gouraud_q24_add_uq8_0_sq8_0_to_sq8_0 add_difference (
      .a_i(right_i), .b_i(inverted), .carry_i(one_i), .s_o(difference)
  );
  blysk_gouraud_q24_add_sq8_24_sq7_24_to_sq8_24 add_sum (
      .a_i(increment), .b_i(shifted), .carry_i(ground_i), .s_o(sum)
  );
  blysk_gouraud_q24_add_sq10_24_sq8_24_to_sq10_24 add_pixel (
      .a_i(intensity), .b_i(increment), .carry_i(ground_i), .s_o(next)
  );
  blysk_gouraud_q24_quantise_sq10_24_to_uq8_0_clamp quant_pixel (.a_i(intensity), .y_o(pixel_o));

endmodule

`default_nettype wire
