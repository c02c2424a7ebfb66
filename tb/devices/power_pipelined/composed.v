// SPDX-License-Identifier: Apache-2.0
// cos^n by its logarithm, with registers at the cuts 2, 3, 4, 6, 7, 9 and 12, block for block: c = 2^-(z + 1) (1 + f),
// x = -n log2 c, brdf = 2^-x. x_7 is x behind cut 7, or behind the last one before level 7. See tb/cosim/composition.
`define STAGES 8
`include "pipelined.vh"
`include "logarithm.vh"

  wire is_zero_7, is_off_11;
  wire [9:0] n_6;
  wire [F:0] gated;
  wire [Z-1:0] zeros_5;
  wire [F-1:0] distance_4;
  wire [PI-1:0] ratio_place_2;
  wire [W:0] ratio_begin_3, power_begin_9;
  wire [CI-1:0] ratio_change_2;
  wire [CI+PI-1:0] ratio_product_3;
  wire [V:0] ratio_4;
  wire [Z+K-1:0] log_6;
  wire [Z+K+9:0] x_7;
  wire [S-1:0] places_10;
  wire [CJ+PJ-1:0] power_product_9;

  pipe #(.D(CI)) pipe_ratio_change (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_change), .q_o(ratio_change_2));
  pipe #(.D(PI)) pipe_ratio_place (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_place), .q_o(ratio_place_2));

  multiplier #(.A(CI), .AS(1), .B(PI), .P(CI + PI)) mul_ratio
      (.a_i(ratio_change_2), .b_i(ratio_place_2), .p_o(ratio_product));

  pipe #(.D(CI + PI)) pipe_ratio_product
      (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_product), .q_o(ratio_product_3));
  pipe #(.D(W + 1), .LENGTH(2)) pipe_ratio_begin
      (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_begin), .q_o(ratio_begin_3));

  adder #(.A(W + 1), .AU(PI), .B(CI + PI), .BS(1), .S(W + PI + 1)) add_ratio
      (.a_i(ratio_begin_3), .b_i(ratio_product_3), .carry_i(zero), .s_o(ratio_line));
  field #(.A(W + PI + 1), .LOW(W + PI - V), .Y(V + 1)) cut_ratio (.a_i(ratio_line), .y_o(ratio));

  pipe #(.D(V + 1)) pipe_ratio (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio), .q_o(ratio_4));
  pipe #(.D(F), .LENGTH(3)) pipe_distance (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(distance), .q_o(distance_4));
  pipe #(.D(Z), .LENGTH(3)) pipe_zeros (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(zeros), .q_o(zeros_5));

  multiplier #(.A(F), .B(V + 1), .P(F + V + 1)) mul_log (.a_i(distance_4), .b_i(ratio_4), .p_o(log_product));
  field #(.A(F + V + 1), .LOW(F - 1 + V - K), .Y(K + 1)) cut_log (.a_i(log_product), .y_o(log_fraction));
  adder #(.A(Z), .AU(K), .B(K + 1), .S(Z + K)) add_log
      (.a_i(zeros_5), .b_i(log_fraction), .carry_i(zero), .s_o(log));

  pipe #(.D(Z + K)) pipe_log (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(log), .q_o(log_6));
  pipe #(.D(10), .LENGTH(4)) pipe_n (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(n), .q_o(n_6));

  multiplier #(.A(10), .B(Z + K), .P(Z + K + 10)) mul_n (.a_i(n_6), .b_i(log_6), .p_o(x));

  pipe #(.D(Z + K + 10)) pipe_power_log (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(x), .q_o(x_7));
  pipe #(.LENGTH(5)) pipe_is_zero (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_zero), .q_o(is_zero_7));

  // 2^-x: a line of the fraction, and a shift by the integer.
  field #(.A(Z + K + 10), .LOW(K + S), .Y(Z + 10 - S)) cut_above (.a_i(x_7), .y_o(above));
  field #(.A(Z + K + 10), .LOW(K), .Y(S)) cut_places (.a_i(x_7), .y_o(places));
  field #(.A(Z + K + 10), .LOW(K - J), .Y(J)) index_power (.a_i(x_7), .y_o(power_segment));
  field #(.A(Z + K + 10), .LOW(K - P), .Y(PJ)) place_power (.a_i(x_7), .y_o(power_place));
  memory #(.A(J), .Y(W + 1)) rom_power (.a_i(power_segment), .y_o(power_begin));
  memory #(.A(J), .Y(CJ)) rom_power_change (.a_i(power_segment), .y_o(power_change));
  multiplier #(.A(CJ), .AS(1), .B(PJ), .P(CJ + PJ)) mul_power
      (.a_i(power_change), .b_i(power_place), .p_o(power_product));

  pipe #(.D(CJ + PJ)) pipe_power_product
      (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_product), .q_o(power_product_9));
  pipe #(.D(W + 1)) pipe_power_begin (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_begin), .q_o(power_begin_9));
  pipe #(.D(S)) pipe_places (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(places), .q_o(places_10));
  pipe pipe_is_off (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_off), .q_o(is_off_11));

  adder #(.A(W + 1), .AU(PJ), .B(CJ + PJ), .BS(1), .S(W + PJ + 1)) add_power
      (.a_i(power_begin_9), .b_i(power_product_9), .carry_i(zero), .s_o(power_line));
  field #(.A(W + PJ + 1), .LOW(W + PJ - V), .Y(V + 1)) cut_power (.a_i(power_line), .y_o(power));
  shifter #(.A(V + 1), .PLACES(S)) shift (.a_i(power), .places_i(places_10), .y_o(shifted));
  round_off #(.A(V + 1), .DROP(V - F), .Y(F + 1)) quant (.a_i(shifted), .y_o(rounded));
  any #(.A(Z + 10 - S)) off (.a_i(above), .b_i(is_zero_7), .y_o(is_off));
  gate #(.A(F + 1)) key_brdf (.a_i(rounded), .off_i(is_off_11), .y_o(gated));

  pipe #(.D(F + 1)) pipe_brdf (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(gated), .q_o(brdf));

endmodule
