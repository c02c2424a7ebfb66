// SPDX-License-Identifier: Apache-2.0
// Begins the composed.v of an iterative device that shades a point: its ports, registers 1..5, control, and multipliers
// 12..14. n and c are in registers 1 and 2; the device's own text makes brdf, of F fraction bits, of a quotient with
// F + 2 digits.
module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] n_i,
    input wire [F:0] cos_i,
    input wire [7:0] r_i, g_i, b_i,
    input wire start_i,
    output wire ready_o,
    output wire [F+7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire take, first, step;
  wire [9:0] n;
  wire [F:0] c, brdf;
  wire [7:0] r, g, b;

  digit_control #(.DIGITS(F + 2)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i),
      .take_o(take), .first_o(first), .step_o(step), .ready_o(ready_o), .done_o(valid_o));
  register #(.D(10)) rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  register #(.D(F + 1)) rg2 (.clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(c));
  register #(.D(8)) rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r));
  register #(.D(8)) rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g));
  register #(.D(8)) rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b));

  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul12 (.a_i(brdf), .b_i(r), .p_o(r_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul13 (.a_i(brdf), .b_i(g), .p_o(g_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul14 (.a_i(brdf), .b_i(b), .p_o(b_o));

