// SPDX-License-Identifier: Apache-2.0
// cos^n by its logarithm, block for block: c = 2^-(z + 1) (1 + f), x = -n log2 c, brdf = 2^-x; see
// tb/cosim/composition.
`include "specular.vh"
`include "logarithm.vh"

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
