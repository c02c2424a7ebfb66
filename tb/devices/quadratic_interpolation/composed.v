// SPDX-License-Identifier: Apache-2.0
// A scan line of a quadratic by forward differences, F fraction bits: with each pixel the first difference grows by the
// second one, the value by the first difference before it; see tb/cosim/composition.
`default_nettype none

module channel #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire load_i, draw_i, ground_i,
    input wire [F+7:0] value_i,
    input wire [F+8:0] first_i,
    input wire [F:0] second_i,
    output wire [7:0] pixel_o
);

  wire [F:0] second;
  wire [F+11:0] first, next_first;
  wire [F+21:0] value, next_value;

  start_register #(.D(F + 1), .DS(1), .Q(F + 1)) rg_second (.clk(clk), .rst_n(rst_n),
      .load_i(load_i), .step_i(draw_i), .d_i(second_i), .sum_i(second), .q_o(second));
  start_register #(.D(F + 9), .DS(1), .Q(F + 12)) rg_first (.clk(clk), .rst_n(rst_n),
      .load_i(load_i), .step_i(draw_i), .d_i(first_i), .sum_i(next_first), .q_o(first));
  start_register #(.D(F + 8), .Q(F + 22)) rg_value (.clk(clk), .rst_n(rst_n),
      .load_i(load_i), .step_i(draw_i), .d_i(value_i), .sum_i(next_value), .q_o(value));
  adder #(.A(F + 12), .AS(1), .B(F + 1), .BS(1), .S(F + 12)) add_first
      (.a_i(first), .b_i(second), .carry_i(ground_i), .s_o(next_first));
  adder #(.A(F + 22), .AS(1), .B(F + 12), .BS(1), .S(F + 22)) add_value
      (.a_i(value), .b_i(first), .carry_i(ground_i), .s_o(next_value));
  rounding #(.A(F + 22), .AS(1), .DROP(F), .Y(8)) quant (.a_i(value), .y_o(pixel_o));

endmodule

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] length_i,
    input wire [F+7:0] r_i, g_i, b_i,
    input wire [F+8:0] dr_i, dg_i, db_i,
    input wire [F:0] ddr_i, ddg_i, ddb_i,
    input wire start_i,
    output wire ready_o,
    output wire [7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire load, low;

  pixel_counter #(.D(10)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i), .length_i(length_i),
      .load_o(load), .draw_o(valid_o), .ready_o(ready_o));
  wired #(.VALUE(0)) ground (.y_o(low));
  channel #(.F(F)) red (.clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(low),
      .value_i(r_i), .first_i(dr_i), .second_i(ddr_i), .pixel_o(r_o));
  channel #(.F(F)) green (.clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(low),
      .value_i(g_i), .first_i(dg_i), .second_i(ddg_i), .pixel_o(g_o));
  channel #(.F(F)) blue (.clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(low),
      .value_i(b_i), .first_i(db_i), .second_i(ddb_i), .pixel_o(b_o));

endmodule

`default_nettype wire
