// SPDX-License-Identifier: Apache-2.0
// UA 22802, block for block: brdf = a (c^2 - c) + c, a from memory 6, limited to [0, 1]; see tb/cosim/composition.
`include "specular.vh"

  // Fraction bits of a and of c^2.
  localparam K = F < 20 ? F : 20;
  localparam D = F < 12 ? 2 * F : F < 23 ? F + 12 : 35;

  wire one, zero;
  wire [D:0] c2;
  wire [D+1:0] minus_c;
  wire [D-2:0] c2_c;
  wire [K+9:0] a;
  wire [K+D+8:0] a_c2_c, parabola;

  wired #(.VALUE(1)) carry28 (.y_o(one));
  wired #(.VALUE(0)) carry30 (.y_o(zero));
  multiplier #(.A(F + 1), .B(F + 1), .P(D + 1), .DROP(2 * F - D)) mul7 (.a_i(c), .b_i(c), .p_o(c2));
  inverters #(.A(F + 1), .U(D - F), .Y(D + 2)) inv8 (.a_i(c), .y_o(minus_c));
  adder #(.A(D + 1), .B(D + 2), .BS(1), .S(D - 1)) add9 (.a_i(c2), .b_i(minus_c), .carry_i(one), .s_o(c2_c));
  memory #(.A(10), .Y(K + 10)) rom6 (.a_i(n), .y_o(a));
  multiplier #(.A(K + 10), .B(D - 1), .BS(1), .P(K + D + 9)) mul10 (.a_i(a), .b_i(c2_c), .p_o(a_c2_c));
  adder #(.A(K + D + 9), .AS(1), .B(F + 1), .BU(K + D - F), .S(K + D + 9)) add11
      (.a_i(a_c2_c), .b_i(c), .carry_i(zero), .s_o(parabola));
  rounding #(.A(K + D + 9), .AS(1), .DROP(K + D - F), .Y(F + 1), .MOST(1 << F)) quant11 (.a_i(parabola), .y_o(brdf));

endmodule
