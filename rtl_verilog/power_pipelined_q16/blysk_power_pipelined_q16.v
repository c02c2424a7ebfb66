// SPDX-License-Identifier: Apache-2.0
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:2d0362bdf6efe5d45ade7ab3638e06e31cecef79220854a7b07e672fcaf31037
//   error against c^n, every code of the cosine: at most 1.27468e-05 (n = 933, c = 0.99993896484375), bias -1.29824e-08; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.00697416 (n = 1000, c = 0.9999930014352216), bias -2.79807e-07; 146779000 inputs, n in 1..1000, exhaustive
//   iCE40: 3870 LUT, 227 carry, 530 FF, 0 DSP, 8192 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 664 LUT, 94 carry, 530 FF, 9 DSP, 8192 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 50.75 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 14757.2 NAND2, 13071 cells, longest path 7.165 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: certificate, settling
`default_nettype none

module blysk_power_pipelined_q16 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [16:0] cos_i,  // 18: cos(delta), 0..1, UQ1.16, codes 0..65536
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    input  wire stall_i,  // keeps a result at the outputs
    output wire ready_o,  // start_i takes the inputs
    output wire [23:0] r_o,  // 25: red, UQ8.16
    output wire [23:0] g_o,  // 26: green, UQ8.16
    output wire [23:0] b_o,  // 27: blue, UQ8.16
    output wire valid_o  // a result is at the outputs
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [16:0] cos_delta;  // rg2: UQ1.16, codes 0..65536
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [7:0] r_last;  // pipe_r: UQ8.0
  wire [7:0] g_last;  // pipe_g: UQ8.0
  wire [7:0] b_last;  // pipe_b: UQ8.0
  wire [16:0] brdf;  // pipe_brdf: UQ1.16, codes 0..65536
  wire [9:0] n_6;  // pipe_n: UQ10.0, codes 1..1000
  wire [3:0] zeros_5;  // pipe_zeros: UQ4.0
  wire is_zero_7;
  wire [15:0] distance_4;  // pipe_distance: UQ1.15, codes 0..32768
  wire [20:0] ratio_begin_3;  // pipe_ratio_begin: UQ1.20
  wire signed [13:0] ratio_change_2;  // pipe_ratio_change: SQ-7.20
  wire [8:0] ratio_place_2;  // pipe_ratio_place: UQ0.9
  wire signed [22:0] ratio_product_3;  // pipe_ratio_product: SQ-7.29
  wire [19:0] ratio_4;  // pipe_ratio: UQ1.19
  wire [31:0] log_6;  // pipe_log: UQ4.28
  wire [41:0] power_log_7;  // pipe_power_log: UQ14.28
  wire [4:0] places_10;  // pipe_places: UQ5.0
  wire [20:0] power_begin_9;  // pipe_power_begin: UQ1.20
  wire signed [25:0] power_product_9;  // pipe_power_product: SQ-7.32
  wire is_off_11;
  wire go;
  wire take;
  wire [1:0] two;  // node2: UQ2.0
  wire carry_one;  // carry_f: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [16:0] normalised;  // norm: UQ2.15
  wire [3:0] zeros;  // norm: UQ4.0
  wire is_zero;
  wire signed [17:0] inverted;  // inv_f: SQ2.15
  wire [15:0] distance;  // add_f: UQ1.15, codes 0..32768
  wire [5:0] ratio_index;  // index_ratio: UQ6.0
  wire [8:0] ratio_place;  // place_ratio: UQ0.9
  wire [20:0] ratio_begin;  // rom_ratio: UQ1.20
  wire signed [13:0] ratio_change;  // rom_ratio_change: SQ-7.20
  wire signed [22:0] ratio_product;  // mul_ratio: SQ-7.29
  wire [29:0] ratio_line;  // add_ratio: UQ1.29
  wire [19:0] ratio;  // cut_ratio: UQ1.19
  wire [35:0] log_product;  // mul_log: UQ2.34
  wire [28:0] log_fraction;  // cut_log: UQ1.28
  wire [31:0] minus_log_cos;  // add_log: UQ4.28
  wire [41:0] minus_log_power;  // mul_n: UQ14.28
  wire [8:0] above;  // cut_above: UQ9.0
  wire [4:0] places;  // cut_places: UQ5.0
  wire [6:0] power_index;  // index_power: UQ7.0
  wire [11:0] power_place;  // place_power: UQ0.12
  wire [20:0] power_begin;  // rom_power: UQ1.20
  wire signed [13:0] power_change;  // rom_power_change: SQ-7.20
  wire signed [25:0] power_product;  // mul_power: SQ-7.32
  wire [32:0] power_line;  // add_power: UQ1.32
  wire [19:0] power_of_fraction;  // cut_power: UQ1.19
  wire [19:0] shifted;  // shift: UQ1.19
  wire [16:0] rounded;  // quant: UQ1.16, codes 0..65536
  wire is_off;
  wire [16:0] brdf_first;  // key_brdf: UQ1.16, codes 0..65536

  blysk_power_pipelined_q16_pipe_8 pipe_valid (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o)
  );
  blysk_power_pipelined_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_power_pipelined_q16_reg_level_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_power_pipelined_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks));
  blysk_power_pipelined_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks));
  blysk_power_pipelined_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks));
  blysk_power_pipelined_q16_pipe_uq8_0_7 pipe_r (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(r_ks), .q_o(r_last));
  blysk_power_pipelined_q16_pipe_uq8_0_7 pipe_g (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(g_ks), .q_o(g_last));
  blysk_power_pipelined_q16_pipe_uq8_0_7 pipe_b (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(b_ks), .q_o(b_last));
  blysk_power_pipelined_q16_pipe_uq1_16_1 pipe_brdf (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(brdf_first), .q_o(brdf)
  );
  blysk_power_pipelined_q16_pipe_uq10_0_4 pipe_n (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(n), .q_o(n_6));
  blysk_power_pipelined_q16_pipe_uq4_0_3 pipe_zeros (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(zeros), .q_o(zeros_5)
  );
  blysk_power_pipelined_q16_pipe_5 pipe_is_zero (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_zero), .q_o(is_zero_7)
  );
  blysk_power_pipelined_q16_pipe_uq1_15_3 pipe_distance (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(distance), .q_o(distance_4)
  );
  blysk_power_pipelined_q16_pipe_uq1_20_2 pipe_ratio_begin (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_begin), .q_o(ratio_begin_3)
  );
  blysk_power_pipelined_q16_pipe_sqm7_20_1 pipe_ratio_change (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_change), .q_o(ratio_change_2)
  );
  blysk_power_pipelined_q16_pipe_uq0_9_1 pipe_ratio_place (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_place), .q_o(ratio_place_2)
  );
  blysk_power_pipelined_q16_pipe_sqm7_29_1 pipe_ratio_product (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_product), .q_o(ratio_product_3)
  );
  blysk_power_pipelined_q16_pipe_uq1_19_1 pipe_ratio (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio), .q_o(ratio_4)
  );
  blysk_power_pipelined_q16_pipe_uq4_28_1 pipe_log (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(minus_log_cos), .q_o(log_6)
  );
  blysk_power_pipelined_q16_pipe_uq14_28_1 pipe_power_log (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(minus_log_power), .q_o(power_log_7)
  );
  blysk_power_pipelined_q16_pipe_uq5_0_1 pipe_places (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(places), .q_o(places_10)
  );
  blysk_power_pipelined_q16_pipe_uq1_20_1 pipe_power_begin (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_begin), .q_o(power_begin_9)
  );
  blysk_power_pipelined_q16_pipe_sqm7_32_1 pipe_power_product (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_product), .q_o(power_product_9)
  );
  blysk_power_pipelined_q16_pipe_1 pipe_is_off (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_off), .q_o(is_off_11)
  );
  blysk_power_pipelined_q16_pipe_control control (
      .start_i(start_i), .stall_i(stall_i), .valid_i(valid_o), .go_o(go), .take_o(take), .ready_o(ready_o)
  );
  blysk_power_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_last), .p_o(r_o));
  blysk_power_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_last), .p_o(g_o));
  blysk_power_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_last), .p_o(b_o));
  blysk_power_pipelined_q16_constant_uq2_0 #(.RAW(2'd2)) node2 (.y_o(two));  // 2
  blysk_power_pipelined_q16_constant_uq1_0 #(.RAW(1'd1)) carry_f (.y_o(carry_one));  // 1
  blysk_power_pipelined_q16_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_power_pipelined_q16_normalise_uq1_16_to_uq2_15_uq4_0 norm (
      .a_i(cos_delta), .m_o(normalised), .zeros_o(zeros), .zero_o(is_zero)
  );
  blysk_power_pipelined_q16_inverter_bank_uq2_15_to_sq2_15 inv_f (.a_i(normalised), .y_o(inverted));
  blysk_power_pipelined_q16_add_uq2_0_sq2_15_to_uq1_15 add_f (
      .a_i(two), .b_i(inverted), .carry_i(carry_one), .s_o(distance)
  );
  blysk_power_pipelined_q16_field_uq2_15_to_uq6_0_from_09 index_ratio (.a_i(normalised), .y_o(ratio_index));
  blysk_power_pipelined_q16_field_uq2_15_to_uq0_9_from_00 place_ratio (.a_i(normalised), .y_o(ratio_place));
  blysk_power_pipelined_q16_rom_uq6_0_to_uq1_20 rom_ratio (.a_i(ratio_index), .y_o(ratio_begin));
  blysk_power_pipelined_q16_rom_uq6_0_to_sqm7_20 rom_ratio_change (.a_i(ratio_index), .y_o(ratio_change));
  blysk_power_pipelined_q16_mul_sqm7_20_uq0_9_to_sqm7_29 mul_ratio (
      .a_i(ratio_change_2), .b_i(ratio_place_2), .p_o(ratio_product)
  );
  blysk_power_pipelined_q16_add_uq1_20_sqm7_29_to_uq1_29 add_ratio (
      .a_i(ratio_begin_3), .b_i(ratio_product_3), .carry_i(grounded), .s_o(ratio_line)
  );
  blysk_power_pipelined_q16_field_uq1_29_to_uq1_19_from_10 cut_ratio (.a_i(ratio_line), .y_o(ratio));
  blysk_power_pipelined_q16_mul_uq1_15_uq1_19_to_uq2_34 mul_log (
      .a_i(distance_4), .b_i(ratio_4), .p_o(log_product)
  );
  blysk_power_pipelined_q16_field_uq2_34_to_uq1_28_from_06 cut_log (.a_i(log_product), .y_o(log_fraction));
  blysk_power_pipelined_q16_add_uq4_0_uq1_28_to_uq4_28 add_log (
      .a_i(zeros_5), .b_i(log_fraction), .carry_i(grounded), .s_o(minus_log_cos)
  );
  blysk_power_pipelined_q16_mul_uq10_0_uq4_28_to_uq14_28 mul_n (.a_i(n_6), .b_i(log_6), .p_o(minus_log_power));
  blysk_power_pipelined_q16_field_uq14_28_to_uq9_0_from_33 cut_above (.a_i(power_log_7), .y_o(above));
  blysk_power_pipelined_q16_field_uq14_28_to_uq5_0_from_28 cut_places (.a_i(power_log_7), .y_o(places));
  blysk_power_pipelined_q16_field_uq14_28_to_uq7_0_from_21 index_power (.a_i(power_log_7), .y_o(power_index));
  blysk_power_pipelined_q16_field_uq14_28_to_uq0_12_from_09 place_power (.a_i(power_log_7), .y_o(power_place));
  blysk_power_pipelined_q16_rom_uq7_0_to_uq1_20 rom_power (.a_i(power_index), .y_o(power_begin));
  blysk_power_pipelined_q16_rom_uq7_0_to_sqm7_20 rom_power_change (.a_i(power_index), .y_o(power_change));
  blysk_power_pipelined_q16_mul_sqm7_20_uq0_12_to_sqm7_32 mul_power (
      .a_i(power_change), .b_i(power_place), .p_o(power_product)
  );
  blysk_power_pipelined_q16_add_uq1_20_sqm7_32_to_uq1_32 add_power (
      .a_i(power_begin_9), .b_i(power_product_9), .carry_i(grounded), .s_o(power_line)
  );
  blysk_power_pipelined_q16_field_uq1_32_to_uq1_19_from_13 cut_power (
      .a_i(power_line), .y_o(power_of_fraction)
  );
  blysk_power_pipelined_q16_shift_right_uq1_19_uq5_0_to_uq1_19 shift (
      .a_i(power_of_fraction), .places_i(places_10), .y_o(shifted)
  );
  blysk_power_pipelined_q16_quantise_uq1_19_to_uq1_16 quant (.a_i(shifted), .y_o(rounded));
  blysk_power_pipelined_q16_either_uq9_0 off (.a_i(above), .b_i(is_zero_7), .y_o(is_off));
  blysk_power_pipelined_q16_key_uq1_16 key_brdf (.a_i(rounded), .off_i(is_off_11), .y_o(brdf_first));

endmodule

`default_nettype wire
