// SPDX-License-Identifier: Apache-2.0
// Lyon's lobe of degree 4, block for block: brdf = max(0, 1 - n/4 (1 - c))^4; see tb/cosim/composition.
`include "specular.vh"

  wire one;
  wire [F+1:0] minus_c;
  wire [F:0] versine;
  wire [9:0] part;
  wire [F+9:0] drop;
  wire [F+10:0] minus_drop, line;
  wire [F+2:0] root;
  wire [F+3:0] square;

  wired #(.VALUE(1)) node1 (.y_o(one));
  inverters #(.A(F + 1), .Y(F + 2)) inv_cos (.a_i(c), .y_o(minus_c));
  adder #(.AU(F), .B(F + 2), .BS(1), .S(F + 1)) add_cos
      (.a_i(one), .b_i(minus_c), .carry_i(one), .s_o(versine));
  // n/4 is n with two fraction bits.
  wires #(.A(10)) part_n (.a_i(n), .y_o(part));
  multiplier #(.A(10), .B(F + 1), .P(F + 10)) mul_n (.a_i(part), .b_i(versine), .p_o(drop));
  inverters #(.A(F + 10), .Y(F + 11)) inv_drop (.a_i(drop), .y_o(minus_drop));
  adder #(.AU(F + 2), .B(F + 11), .BS(1), .S(F + 11)) add_line
      (.a_i(one), .b_i(minus_drop), .carry_i(one), .s_o(line));
  rounding #(.A(F + 11), .AS(1), .Y(F + 3), .MOST(1 << (F + 2))) quant_line (.a_i(line), .y_o(root));
  // The first square keeps three fraction bits more than the BRDF.
  multiplier #(.A(F + 3), .B(F + 3), .P(F + 4), .DROP(F + 1)) square2 (.a_i(root), .b_i(root), .p_o(square));
  multiplier #(.A(F + 4), .B(F + 4), .P(F + 1), .DROP(F + 6)) square4 (.a_i(square), .b_i(square), .p_o(brdf));

endmodule
