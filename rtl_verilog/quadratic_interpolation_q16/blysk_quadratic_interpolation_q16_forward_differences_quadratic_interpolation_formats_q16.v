// SPDX-License-Identifier: Apache-2.0
// device quadratic-interpolation, format q16, 16 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q16_forward_differences_quadratic_interpolation_formats_q16 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire draw_i,
    input  wire ground_i,
    input  wire [23:0] value_i,  // UQ8.16
    input  wire signed [24:0] first_i,  // SQ8.16
    input  wire signed [16:0] second_i,  // SQ0.16
    output wire [7:0] pixel_o  // UQ8.0
);

  wire signed [16:0] second;  // rg_second: SQ0.16
  wire signed [27:0] first;  // rg_first: SQ11.16
  wire signed [37:0] value;  // rg_value: SQ21.16
  wire signed [27:0] next_first;  // add_first: SQ11.16
  wire signed [37:0] next_value;  // add_value: SQ21.16

  blysk_quadratic_interpolation_q16_start_register_sq0_16_sq0_16_to_sq0_16 rg_second (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(second_i), .sum_i(second), .q_o(second)
  );
  blysk_quadratic_interpolation_q16_start_register_sq8_16_sq11_16_to_sq11_16 rg_first (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(first_i), .sum_i(next_first), .q_o(first)
  );
  blysk_quadratic_interpolation_q16_start_register_uq8_16_sq21_16_to_sq21_16 rg_value (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(value_i), .sum_i(next_value), .q_o(value)
  );
  blysk_quadratic_interpolation_q16_add_sq11_16_sq0_16_to_sq11_16 add_first (
      .a_i(first), .b_i(second), .carry_i(ground_i), .s_o(next_first)
  );
  blysk_quadratic_interpolation_q16_add_sq21_16_sq11_16_to_sq21_16 add_value (
      .a_i(value), .b_i(first), .carry_i(ground_i), .s_o(next_value)
  );
  blysk_quadratic_interpolation_q16_quantise_sq21_16_to_uq8_0_clamp quant (.a_i(value), .y_o(pixel_o));

endmodule

`default_nettype wire
