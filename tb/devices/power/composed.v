// SPDX-License-Identifier: Apache-2.0
// cos^n by its logarithm, block for block: c = 2^-(z + 1) (1 + f), x = -n log2 c, brdf = 2^-x; see tb/cosim/composition.
`include "specular.vh"

  // The segments of f are 2^-I long, those of the fraction of x 2^-J. Fraction bits of the memories' words, of what is cut
  // from the lines, of the logarithm, and of what is kept of x; bits of the count of zeros and of a shift.
  localparam I = F / 2 - 2;
  localparam J = F / 2 - 1;
  localparam W = F + 4;
  localparam V = F + 3;
  localparam K = 2 * F + 1 < F + 12 ? 2 * F + 1 : F + 12;
  localparam P = F + 3;
  localparam Z = $clog2(F);
  localparam S = $clog2(F + 3);
  // Places of 1 + f and of x below a segment; bits of a change: no line falls by 2^-(I + 1) or 2^-J.
  localparam PI = F - 1 - I;
  localparam PJ = P - J;
  localparam CI = W - I;
  localparam CJ = W - J + 1;

  wire [1:0] two;
  wire one, zero, is_zero, is_off;
  wire [F:0] mantissa, rounded;
  wire [Z-1:0] zeros;
  wire [F+1:0] minus_mantissa;
  wire [F-1:0] distance;
  wire [I-1:0] ratio_segment;
  wire [PI-1:0] ratio_place;
  wire [W:0] ratio_begin, power_begin;
  wire [CI-1:0] ratio_change;
  wire [CI+PI-1:0] ratio_product;
  wire [W+PI:0] ratio_line;
  wire [V:0] ratio, power, shifted;
  wire [F+V:0] log_product;
  wire [K:0] log_fraction;
  wire [Z+K-1:0] log;
  wire [Z+K+9:0] x;
  wire [Z+9-S:0] above;
  wire [S-1:0] places;
  wire [J-1:0] power_segment;
  wire [PJ-1:0] power_place;
  wire [CJ-1:0] power_change;
  wire [CJ+PJ-1:0] power_product;
  wire [W+PJ:0] power_line;

  wired #(.Y(2), .VALUE(2)) node2 (.y_o(two));
  wired #(.VALUE(1)) carry_f (.y_o(one));
  wired #(.VALUE(0)) ground (.y_o(zero));

  // -log2 c = z + (1 - f) r(f)
  normaliser #(.F(F), .Z(Z)) norm (.a_i(c), .m_o(mantissa), .zeros_o(zeros), .zero_o(is_zero));
  inverters #(.A(F + 1), .Y(F + 2)) inv_f (.a_i(mantissa), .y_o(minus_mantissa));
  adder #(.A(2), .AU(F - 1), .B(F + 2), .BS(1), .S(F)) add_f
      (.a_i(two), .b_i(minus_mantissa), .carry_i(one), .s_o(distance));
  field #(.A(F + 1), .LOW(PI), .Y(I)) index_ratio (.a_i(mantissa), .y_o(ratio_segment));
  field #(.A(F + 1), .Y(PI)) place_ratio (.a_i(mantissa), .y_o(ratio_place));
  memory #(.A(I), .Y(W + 1)) rom_ratio (.a_i(ratio_segment), .y_o(ratio_begin));
  memory #(.A(I), .Y(CI)) rom_ratio_change (.a_i(ratio_segment), .y_o(ratio_change));
  multiplier #(.A(CI), .AS(1), .B(PI), .P(CI + PI)) mul_ratio
      (.a_i(ratio_change), .b_i(ratio_place), .p_o(ratio_product));
  adder #(.A(W + 1), .AU(PI), .B(CI + PI), .BS(1), .S(W + PI + 1)) add_ratio
      (.a_i(ratio_begin), .b_i(ratio_product), .carry_i(zero), .s_o(ratio_line));
  field #(.A(W + PI + 1), .LOW(W + PI - V), .Y(V + 1)) cut_ratio (.a_i(ratio_line), .y_o(ratio));
  multiplier #(.A(F), .B(V + 1), .P(F + V + 1)) mul_log (.a_i(distance), .b_i(ratio), .p_o(log_product));
  field #(.A(F + V + 1), .LOW(F - 1 + V - K), .Y(K + 1)) cut_log (.a_i(log_product), .y_o(log_fraction));
  adder #(.A(Z), .AU(K), .B(K + 1), .S(Z + K)) add_log
      (.a_i(zeros), .b_i(log_fraction), .carry_i(zero), .s_o(log));

  multiplier #(.A(10), .B(Z + K), .P(Z + K + 10)) mul_n (.a_i(n), .b_i(log), .p_o(x));

  // 2^-x: a line of the fraction, and a shift by the integer.
  field #(.A(Z + K + 10), .LOW(K + S), .Y(Z + 10 - S)) cut_above (.a_i(x), .y_o(above));
  field #(.A(Z + K + 10), .LOW(K), .Y(S)) cut_places (.a_i(x), .y_o(places));
  field #(.A(Z + K + 10), .LOW(K - J), .Y(J)) index_power (.a_i(x), .y_o(power_segment));
  field #(.A(Z + K + 10), .LOW(K - P), .Y(PJ)) place_power (.a_i(x), .y_o(power_place));
  memory #(.A(J), .Y(W + 1)) rom_power (.a_i(power_segment), .y_o(power_begin));
  memory #(.A(J), .Y(CJ)) rom_power_change (.a_i(power_segment), .y_o(power_change));
  multiplier #(.A(CJ), .AS(1), .B(PJ), .P(CJ + PJ)) mul_power
      (.a_i(power_change), .b_i(power_place), .p_o(power_product));
  adder #(.A(W + 1), .AU(PJ), .B(CJ + PJ), .BS(1), .S(W + PJ + 1)) add_power
      (.a_i(power_begin), .b_i(power_product), .carry_i(zero), .s_o(power_line));
  field #(.A(W + PJ + 1), .LOW(W + PJ - V), .Y(V + 1)) cut_power (.a_i(power_line), .y_o(power));
  shifter #(.A(V + 1), .PLACES(S)) shift (.a_i(power), .places_i(places), .y_o(shifted));
  round_off #(.A(V + 1), .DROP(V - F), .Y(F + 1)) quant (.a_i(shifted), .y_o(rounded));
  any #(.A(Z + 10 - S)) off (.a_i(above), .b_i(is_zero), .y_o(is_off));
  gate #(.A(F + 1)) key_brdf (.a_i(rounded), .off_i(is_off), .y_o(brdf));

endmodule
