// SPDX-License-Identifier: Apache-2.0
// [T] fig. 3.1, block for block: brdf = (m (c - 1) + 1)^2, m = (n + 1)/3 from memory 33, and 0 where m (c - 1) + 1 is
// negative; see tb/cosim/composition.
`define RG_N rg2
`define RG_COS rg1
`define BUF_VALID buf_valid
`define MUL_RED mul_red
`define MUL_GREEN mul_green
`define MUL_BLUE mul_blue
`include "specular.vh"

  wire all_ones, zero, one, beyond_root;
  wire [F:0] square, c_1;
  wire [F+8:0] m;
  wire [2*F+9:0] m_c_1, line;
  wire [F+4:0] limited;

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

endmodule
