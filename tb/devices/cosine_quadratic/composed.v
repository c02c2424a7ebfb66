// SPDX-License-Identifier: Apache-2.0
// [T] fig. 3.1, block for block: brdf = (m (c - 1) + 1)^2, m = (n + 1)/3 from memory 33, and 0 where m (c - 1) + 1 is
// negative; see tb/cosim/composition.
module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] n_i,
    input wire n_we_i,
    input wire [F:0] cos_i,
    input wire cos_we_i,
    input wire [7:0] r_i,
    input wire r_we_i,
    input wire [7:0] g_i,
    input wire g_we_i,
    input wire [7:0] b_i,
    input wire b_we_i,
    output wire [F+7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire all_ones, zero, one, beyond_root;
  wire [9:0] n;
  wire [F:0] c, square, brdf;
  wire [7:0] r, g, b;
  wire [F:0] c_1;
  wire [F+8:0] m;
  wire [2*F+9:0] m_c_1, line;
  wire [F+4:0] limited;

  register_trailing #(.D(F + 1)) rg1 (.clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(c));
  register #(.D(10)) rg2 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  register #(.D(8)) rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r));
  register #(.D(8)) rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g));
  register #(.D(8)) rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b));
  wires buf_valid (.a_i(cos_we_i), .y_o(valid_o));

  wired #(.VALUE(1)) ones6 (.y_o(all_ones));
  wired #(.VALUE(0)) ground (.y_o(zero));
  wired #(.VALUE(1)) carry29 (.y_o(one));
  adder #(.A(F + 1), .B(1), .BS(1), .BU(F), .S(F + 1)) add6
      (.a_i(c), .b_i(all_ones), .carry_i(zero), .s_o(c_1));
  memory #(.A(10), .Y(F + 9)) rom33 (.a_i(n), .y_o(m));
  multiplier #(.A(F + 9), .B(F + 1), .BS(1), .P(2 * F + 10)) mul7 (.a_i(m), .b_i(c_1), .p_o(m_c_1));
  adder #(.A(2 * F + 10), .AS(1), .B(1), .BU(2 * F), .CU(2 * F), .S(2 * F + 10)) add8
      (.a_i(m_c_1), .b_i(zero), .carry_i(one), .s_o(line));
  // The line keeps F + 3 fraction bits, and [-1, 1].
  rounding #(.A(2 * F + 10), .AS(1), .DROP(F - 3), .Y(F + 5), .LEAST(-(1 << (F + 3))), .MOST(1 << (F + 3))) quant8
      (.a_i(line), .y_o(limited));
  multiplier #(.A(F + 5), .AS(1), .B(F + 5), .BS(1), .P(F + 1), .DROP(F + 6)) mul10
      (.a_i(limited), .b_i(limited), .p_o(square));
  sign #(.A(2 * F + 10)) sign8 (.a_i(line), .negative_o(beyond_root));
  gate #(.A(F + 1)) key12 (.a_i(square), .off_i(beyond_root), .y_o(brdf));

  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul_red (.a_i(brdf), .b_i(r), .p_o(r_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul_green (.a_i(brdf), .b_i(g), .p_o(g_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul_blue (.a_i(brdf), .b_i(b), .p_o(b_o));

endmodule
