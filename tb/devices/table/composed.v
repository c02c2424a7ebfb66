// SPDX-License-Identifier: Apache-2.0
// A memory of 256 lines, block for block: brdf = e^-t, t = n u (1 + u/2), u = 1 - c, limited below 8; see
// tb/cosim/composition.
`include "specular.vh"

  // Fraction bits of u (1 + u/2), of the memories' words, and of the place in a segment of 1/32.
  localparam T = F < 16 ? F : 16;
  localparam K = 2 * F + 1 < T + 12 ? 2 * F + 1 : T + 12;
  localparam W = T + 3;
  localparam P = T - 1;

  wire one, zero;
  wire [F:0] u, half_u;
  wire [F+1:0] factor;
  wire [K:0] t_of_c;
  wire [K+10:0] t;
  wire [P+7:0] limited;
  wire [7:0] segment;
  wire [P-1:0] place;
  wire [W:0] begin_of_line;
  wire [W-5:0] change;
  wire [W+P-5:0] change_there;
  wire [W+P:0] line;

  wired #(.VALUE(1)) node1 (.y_o(one));
  wired #(.VALUE(0)) ground (.y_o(zero));
  one_minus #(.A(F + 1)) sub_cos (.a_i(c), .y_o(u));
  // u/2 is u with one fraction bit more.
  wires #(.A(F + 1)) halve_versine (.a_i(u), .y_o(half_u));
  adder #(.AU(F + 1), .B(F + 1), .S(F + 2)) add_factor (.a_i(one), .b_i(half_u), .carry_i(zero), .s_o(factor));
  multiplier #(.A(F + 1), .B(F + 2), .P(K + 1), .DROP(2 * F + 1 - K)) mul_log
      (.a_i(u), .b_i(factor), .p_o(t_of_c));
  multiplier #(.A(10), .B(K + 1), .P(K + 11)) mul_n (.a_i(n), .b_i(t_of_c), .p_o(t));
  rounding #(.A(K + 11), .DROP(K - P - 5), .Y(P + 8)) quant_log (.a_i(t), .y_o(limited));
  field #(.A(P + 8), .LOW(P), .Y(8)) cut_index (.a_i(limited), .y_o(segment));
  field #(.A(P + 8), .Y(P)) cut_place (.a_i(limited), .y_o(place));
  memory #(.A(8), .Y(W + 1)) rom_begin (.a_i(segment), .y_o(begin_of_line));
  memory #(.A(8), .Y(W - 4)) rom_change (.a_i(segment), .y_o(change));
  multiplier #(.A(W - 4), .AS(1), .B(P), .P(W + P - 4)) mul_place
      (.a_i(change), .b_i(place), .p_o(change_there));
  adder #(.A(W + 1), .AU(P), .B(W + P - 4), .BS(1), .S(W + P + 1)) add_line
      (.a_i(begin_of_line), .b_i(change_there), .carry_i(zero), .s_o(line));
  round_off #(.A(W + P + 1), .DROP(W + P - F), .Y(F + 1)) quant (.a_i(line), .y_o(brdf));

endmodule
