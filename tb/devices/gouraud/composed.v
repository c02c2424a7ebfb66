// SPDX-License-Identifier: Apache-2.0
// A scan line of pixels left + x increment, increment = (right - left) times F binary places of 1/length, formed as in
// [T] fig. 2.13; see tb/cosim/composition.
`default_nettype none

module channel #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire load_i, step_i, draw_i, digit_i, one_i, ground_i,
    input wire [7:0] left_i, right_i,
    output wire [7:0] pixel_o
);

  wire [8:0] inverted, difference;
  wire [F+7:0] shifted;
  wire [F+8:0] sum, increment;
  wire [F+10:0] next, intensity;

  inverters #(.A(8), .Y(9)) inv_left (.a_i(left_i), .y_o(inverted));
  adder #(.A(8), .B(9), .BS(1), .S(9)) add_difference
      (.a_i(right_i), .b_i(inverted), .carry_i(one_i), .s_o(difference));
  shift_register #(.D(9), .DU(F), .Q(F + 8)) rg_shift
      (.clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(step_i), .d_i(difference), .q_o(shifted));
  adder #(.A(F + 9), .AS(1), .B(F + 8), .BS(1), .S(F + 9)) add_sum
      (.a_i(increment), .b_i(shifted), .carry_i(ground_i), .s_o(sum));
  sum_register #(.D(9), .DU(F), .Q(F + 9)) rg_sum (.clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(step_i),
      .add_i(digit_i), .d_i(difference), .sum_i(sum), .q_o(increment));
  adder #(.A(F + 11), .AS(1), .B(F + 9), .BS(1), .S(F + 11)) add_pixel
      (.a_i(intensity), .b_i(increment), .carry_i(ground_i), .s_o(next));
  start_register #(.D(8), .DU(F), .Q(F + 11)) rg_pixel
      (.clk(clk), .rst_n(rst_n), .load_i(load_i), .step_i(draw_i), .d_i(left_i), .sum_i(next), .q_o(intensity));
  rounding #(.A(F + 11), .AS(1), .DROP(F), .Y(8)) quant_pixel (.a_i(intensity), .y_o(pixel_o));

endmodule

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] length_i,
    input wire [7:0] r0_i, g0_i, b0_i, r1_i, g1_i, b1_i,
    input wire start_i,
    output wire ready_o,
    output wire [7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire load, step, digit, high, low;
  wire [F:0] digits;

  line_control #(.STEPS(F), .D(10)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i), .length_i(length_i),
      .load_o(load), .step_o(step), .draw_o(valid_o), .ready_o(ready_o));
  memory #(.A(10), .Y(F + 1)) rom_digits (.a_i(length_i), .y_o(digits));
  digit_register #(.D(F + 1)) rg_digits
      (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(digits), .digit_o(digit));
  wired #(.VALUE(1)) one (.y_o(high));
  wired #(.VALUE(0)) ground (.y_o(low));
  channel #(.F(F)) red (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit),
      .one_i(high), .ground_i(low), .left_i(r0_i), .right_i(r1_i), .pixel_o(r_o));
  channel #(.F(F)) green (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit),
      .one_i(high), .ground_i(low), .left_i(g0_i), .right_i(g1_i), .pixel_o(g_o));
  channel #(.F(F)) blue (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit),
      .one_i(high), .ground_i(low), .left_i(b0_i), .right_i(b1_i), .pixel_o(b_o));

endmodule

`default_nettype wire
