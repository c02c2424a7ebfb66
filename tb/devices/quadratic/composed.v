// SPDX-License-Identifier: Apache-2.0
// [P] fig. 1, block for block: brdf = a (c^2 - c) + c, a = S n - 1/2, limited to [0, 1]; see tb/cosim/composition.
`include "specular.vh"

  // Fraction bits of a and of c^2; S = 2 (1 - e^(-1/2)), rounded from 40 bits.
  localparam K = F < 20 ? F : 20;
  localparam D = F < 12 ? 2 * F : F < 23 ? F + 12 : 35;
  localparam [39:0] S40 = 40'd865248229639;
  localparam [K-1:0] S = (S40 + (40'd1 << (39 - K))) >> (40 - K);

  wire one, zero;
  wire [D:0] c2;
  wire [D+1:0] minus_c;
  wire [D-2:0] c2_c;
  wire [K-1:0] s;
  wire [1:0] minus_half;
  wire [K+9:0] s_n, a;
  wire [K+D+8:0] a_c2_c, parabola;

  wired #(.VALUE(1)) carry28 (.y_o(one));
  wired #(.VALUE(0)) carry30 (.y_o(zero));
  multiplier #(.A(F + 1), .B(F + 1), .P(D + 1), .DROP(2 * F - D)) mul7 (.a_i(c), .b_i(c), .p_o(c2));
  inverters #(.A(F + 1), .U(D - F), .Y(D + 2)) inv8 (.a_i(c), .y_o(minus_c));
  adder #(.A(D + 1), .B(D + 2), .BS(1), .S(D - 1)) add9 (.a_i(c2), .b_i(minus_c), .carry_i(one), .s_o(c2_c));
  wired #(.Y(K), .VALUE(S)) node31 (.y_o(s));
  wired #(.Y(2), .VALUE(2'b11)) node32 (.y_o(minus_half));
  multiplier #(.A(10), .B(K), .P(K + 10)) mul6 (.a_i(n), .b_i(s), .p_o(s_n));
  adder #(.A(K + 10), .B(2), .BS(1), .BU(K - 1), .S(K + 10)) add15
      (.a_i(s_n), .b_i(minus_half), .carry_i(zero), .s_o(a));
  multiplier #(.A(K + 10), .B(D - 1), .BS(1), .P(K + D + 9)) mul10 (.a_i(a), .b_i(c2_c), .p_o(a_c2_c));
  adder #(.A(K + D + 9), .AS(1), .B(F + 1), .BU(K + D - F), .S(K + D + 9)) add11
      (.a_i(a_c2_c), .b_i(c), .carry_i(zero), .s_o(parabola));
  rounding #(.A(K + D + 9), .AS(1), .DROP(K + D - F), .Y(F + 1), .MOST(1 << F)) quant11 (.a_i(parabola), .y_o(brdf));

endmodule
