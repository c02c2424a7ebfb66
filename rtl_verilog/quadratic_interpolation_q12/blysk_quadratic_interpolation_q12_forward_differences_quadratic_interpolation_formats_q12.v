// SPDX-License-Identifier: Apache-2.0
// device quadratic-interpolation, format q12, 12 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q12_forward_differences_quadratic_interpolation_formats_q12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire draw_i,
    input  wire ground_i,
    input  wire [19:0] value_i,  // UQ8.12
    input  wire signed [20:0] first_i,  // SQ8.12
    input  wire signed [12:0] second_i,  // SQ0.12
    output wire [7:0] pixel_o  // UQ8.0
);

  wire signed [12:0] second;  // rg_second: SQ0.12
  wire signed [23:0] first;  // rg_first: SQ11.12
  wire signed [33:0] value;  // rg_value: SQ21.12
  wire signed [23:0] next_first;  // add_first: SQ11.12
  wire signed [33:0] next_value;  // add_value: SQ21.12

  blysk_quadratic_interpolation_q12_start_register_sq0_12_sq0_12_to_sq0_12 rg_second (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(second_i), .sum_i(second), .q_o(second)
  );
  blysk_quadratic_interpolation_q12_start_register_sq8_12_sq11_12_to_sq11_12 rg_first (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(first_i), .sum_i(next_first), .q_o(first)
  );
  blysk_quadratic_interpolation_q12_start_register_uq8_12_sq21_12_to_sq21_12 rg_value (
      .clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(value_i), .sum_i(next_value), .q_o(value)
  );
  blysk_quadratic_interpolation_q12_add_sq11_12_sq0_12_to_sq11_12 add_first (
      .a_i(first), .b_i(second), .carry_i(ground_i), .s_o(next_first)
  );
  blysk_quadratic_interpolation_q12_add_sq21_12_sq11_12_to_sq21_12 add_value (
      .a_i(value), .b_i(first), .carry_i(ground_i), .s_o(next_value)
  );
  blysk_quadratic_interpolation_q12_quantise_sq21_12_to_uq8_0_clamp quant (.a_i(value), .y_o(pixel_o));

endmodule

`default_nettype wire
