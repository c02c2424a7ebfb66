// SPDX-License-Identifier: Apache-2.0
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:0281924ff18d8a08bff614d1347bbe8c3150e485deb4a1f313a385869b5d77b4
//   error against c^n, every code of the cosine: at most 0.00283121 (n = 143, c = 0.99609375), bias -3.03979e-06; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias 0.00120978; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: that of power, whose BRDF it computes: BRDF within 0.0035 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0028312142333930534 seen, 257000 inputs, exhaustive
//   iCE40: 1622 LUT, 138 carry, 423 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 138 LUT, 40 carry, 423 FF, 8 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 72.33 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 7537.3 NAND2, 6230 cells, longest path 6.008 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_power_pipelined_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [8:0] cos_i,  // 18: cos(delta), 0..1, UQ1.8, codes 0..256
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    input  wire stall_i,  // keeps a result at the outputs
    output wire ready_o,  // start_i takes the inputs
    output wire [15:0] r_o,  // 25: red, UQ8.8
    output wire [15:0] g_o,  // 26: green, UQ8.8
    output wire [15:0] b_o,  // 27: blue, UQ8.8
    output wire valid_o  // a result is at the outputs
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [8:0] cos_delta;  // rg2: UQ1.8, codes 0..256
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [7:0] r_last;  // pipe_r: UQ8.0
  wire [7:0] g_last;  // pipe_g: UQ8.0
  wire [7:0] b_last;  // pipe_b: UQ8.0
  wire [8:0] brdf;  // pipe_brdf: UQ1.8, codes 0..256
  wire [9:0] n_6;  // pipe_n: UQ10.0, codes 1..1000
  wire [2:0] zeros_5;  // pipe_zeros: UQ3.0
  wire is_zero_7;
  wire [7:0] distance_4;  // pipe_distance: UQ1.7, codes 0..128
  wire [12:0] ratio_begin_3;  // pipe_ratio_begin: UQ1.12
  wire signed [9:0] ratio_change_2;  // pipe_ratio_change: SQ-3.12
  wire [4:0] ratio_place_2;  // pipe_ratio_place: UQ0.5
  wire signed [14:0] ratio_product_3;  // pipe_ratio_product: SQ-3.17
  wire [11:0] ratio_4;  // pipe_ratio: UQ1.11
  wire [19:0] log_6;  // pipe_log: UQ3.17
  wire [29:0] power_log_7;  // pipe_power_log: UQ13.17
  wire [3:0] places_10;  // pipe_places: UQ4.0
  wire [12:0] power_begin_9;  // pipe_power_begin: UQ1.12
  wire signed [17:0] power_product_9;  // pipe_power_product: SQ-3.20
  wire is_off_11;
  wire go;
  wire take;
  wire [1:0] two;  // node2: UQ2.0
  wire carry_one;  // carry_f: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [8:0] normalised;  // norm: UQ2.7
  wire [2:0] zeros;  // norm: UQ3.0
  wire is_zero;
  wire signed [9:0] inverted;  // inv_f: SQ2.7
  wire [7:0] distance;  // add_f: UQ1.7, codes 0..128
  wire [1:0] ratio_index;  // index_ratio: UQ2.0
  wire [4:0] ratio_place;  // place_ratio: UQ0.5
  wire [12:0] ratio_begin;  // rom_ratio: UQ1.12
  wire signed [9:0] ratio_change;  // rom_ratio_change: SQ-3.12
  wire signed [14:0] ratio_product;  // mul_ratio: SQ-3.17
  wire [17:0] ratio_line;  // add_ratio: UQ1.17
  wire [11:0] ratio;  // cut_ratio: UQ1.11
  wire [19:0] log_product;  // mul_log: UQ2.18
  wire [17:0] log_fraction;  // cut_log: UQ1.17
  wire [19:0] minus_log_cos;  // add_log: UQ3.17
  wire [29:0] minus_log_power;  // mul_n: UQ13.17
  wire [8:0] above;  // cut_above: UQ9.0
  wire [3:0] places;  // cut_places: UQ4.0
  wire [2:0] power_index;  // index_power: UQ3.0
  wire [7:0] power_place;  // place_power: UQ0.8
  wire [12:0] power_begin;  // rom_power: UQ1.12
  wire signed [9:0] power_change;  // rom_power_change: SQ-3.12
  wire signed [17:0] power_product;  // mul_power: SQ-3.20
  wire [20:0] power_line;  // add_power: UQ1.20
  wire [11:0] power_of_fraction;  // cut_power: UQ1.11
  wire [11:0] shifted;  // shift: UQ1.11
  wire [8:0] rounded;  // quant: UQ1.8, codes 0..256
  wire is_off;
  wire [8:0] brdf_first;  // key_brdf: UQ1.8, codes 0..256

  blysk_power_pipelined_q8_pipe_8 pipe_valid (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o)
  );
  blysk_power_pipelined_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_power_pipelined_q8_reg_level_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_power_pipelined_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks));
  blysk_power_pipelined_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks));
  blysk_power_pipelined_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks));
  blysk_power_pipelined_q8_pipe_uq8_0_7 pipe_r (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(r_ks), .q_o(r_last));
  blysk_power_pipelined_q8_pipe_uq8_0_7 pipe_g (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(g_ks), .q_o(g_last));
  blysk_power_pipelined_q8_pipe_uq8_0_7 pipe_b (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(b_ks), .q_o(b_last));
  blysk_power_pipelined_q8_pipe_uq1_8_1 pipe_brdf (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(brdf_first), .q_o(brdf)
  );
  blysk_power_pipelined_q8_pipe_uq10_0_4 pipe_n (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(n), .q_o(n_6));
  blysk_power_pipelined_q8_pipe_uq3_0_3 pipe_zeros (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(zeros), .q_o(zeros_5)
  );
  blysk_power_pipelined_q8_pipe_5 pipe_is_zero (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_zero), .q_o(is_zero_7)
  );
  blysk_power_pipelined_q8_pipe_uq1_7_3 pipe_distance (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(distance), .q_o(distance_4)
  );
  blysk_power_pipelined_q8_pipe_uq1_12_2 pipe_ratio_begin (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_begin), .q_o(ratio_begin_3)
  );
  blysk_power_pipelined_q8_pipe_sqm3_12_1 pipe_ratio_change (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_change), .q_o(ratio_change_2)
  );
  blysk_power_pipelined_q8_pipe_uq0_5_1 pipe_ratio_place (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_place), .q_o(ratio_place_2)
  );
  blysk_power_pipelined_q8_pipe_sqm3_17_1 pipe_ratio_product (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio_product), .q_o(ratio_product_3)
  );
  blysk_power_pipelined_q8_pipe_uq1_11_1 pipe_ratio (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(ratio), .q_o(ratio_4)
  );
  blysk_power_pipelined_q8_pipe_uq3_17_1 pipe_log (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(minus_log_cos), .q_o(log_6)
  );
  blysk_power_pipelined_q8_pipe_uq13_17_1 pipe_power_log (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(minus_log_power), .q_o(power_log_7)
  );
  blysk_power_pipelined_q8_pipe_uq4_0_1 pipe_places (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(places), .q_o(places_10)
  );
  blysk_power_pipelined_q8_pipe_uq1_12_1 pipe_power_begin (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_begin), .q_o(power_begin_9)
  );
  blysk_power_pipelined_q8_pipe_sqm3_20_1 pipe_power_product (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(power_product), .q_o(power_product_9)
  );
  blysk_power_pipelined_q8_pipe_1 pipe_is_off (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(is_off), .q_o(is_off_11)
  );
  blysk_power_pipelined_q8_pipe_control control (
      .start_i(start_i), .stall_i(stall_i), .valid_i(valid_o), .go_o(go), .take_o(take), .ready_o(ready_o)
  );
  blysk_power_pipelined_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_last), .p_o(r_o));
  blysk_power_pipelined_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_last), .p_o(g_o));
  blysk_power_pipelined_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_last), .p_o(b_o));
  blysk_power_pipelined_q8_constant_uq2_0 #(.RAW(2'd2)) node2 (.y_o(two));  // 2
  blysk_power_pipelined_q8_constant_uq1_0 #(.RAW(1'd1)) carry_f (.y_o(carry_one));  // 1
  blysk_power_pipelined_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_power_pipelined_q8_normalise_uq1_8_to_uq2_7_uq3_0 norm (
      .a_i(cos_delta), .m_o(normalised), .zeros_o(zeros), .zero_o(is_zero)
  );
  blysk_power_pipelined_q8_inverter_bank_uq2_7_to_sq2_7 inv_f (.a_i(normalised), .y_o(inverted));
  blysk_power_pipelined_q8_add_uq2_0_sq2_7_to_uq1_7 add_f (
      .a_i(two), .b_i(inverted), .carry_i(carry_one), .s_o(distance)
  );
  blysk_power_pipelined_q8_field_uq2_7_to_uq2_0_from_05 index_ratio (.a_i(normalised), .y_o(ratio_index));
  blysk_power_pipelined_q8_field_uq2_7_to_uq0_5_from_00 place_ratio (.a_i(normalised), .y_o(ratio_place));
  blysk_power_pipelined_q8_rom_uq2_0_to_uq1_12 rom_ratio (.a_i(ratio_index), .y_o(ratio_begin));
  blysk_power_pipelined_q8_rom_uq2_0_to_sqm3_12 rom_ratio_change (.a_i(ratio_index), .y_o(ratio_change));
  blysk_power_pipelined_q8_mul_sqm3_12_uq0_5_to_sqm3_17 mul_ratio (
      .a_i(ratio_change_2), .b_i(ratio_place_2), .p_o(ratio_product)
  );
  blysk_power_pipelined_q8_add_uq1_12_sqm3_17_to_uq1_17 add_ratio (
      .a_i(ratio_begin_3), .b_i(ratio_product_3), .carry_i(grounded), .s_o(ratio_line)
  );
  blysk_power_pipelined_q8_field_uq1_17_to_uq1_11_from_06 cut_ratio (.a_i(ratio_line), .y_o(ratio));
  blysk_power_pipelined_q8_mul_uq1_7_uq1_11_to_uq2_18 mul_log (
      .a_i(distance_4), .b_i(ratio_4), .p_o(log_product)
  );
  blysk_power_pipelined_q8_field_uq2_18_to_uq1_17_from_01 cut_log (.a_i(log_product), .y_o(log_fraction));
  blysk_power_pipelined_q8_add_uq3_0_uq1_17_to_uq3_17 add_log (
      .a_i(zeros_5), .b_i(log_fraction), .carry_i(grounded), .s_o(minus_log_cos)
  );
  blysk_power_pipelined_q8_mul_uq10_0_uq3_17_to_uq13_17 mul_n (.a_i(n_6), .b_i(log_6), .p_o(minus_log_power));
  blysk_power_pipelined_q8_field_uq13_17_to_uq9_0_from_21 cut_above (.a_i(power_log_7), .y_o(above));
  blysk_power_pipelined_q8_field_uq13_17_to_uq4_0_from_17 cut_places (.a_i(power_log_7), .y_o(places));
  blysk_power_pipelined_q8_field_uq13_17_to_uq3_0_from_14 index_power (.a_i(power_log_7), .y_o(power_index));
  blysk_power_pipelined_q8_field_uq13_17_to_uq0_8_from_06 place_power (.a_i(power_log_7), .y_o(power_place));
  blysk_power_pipelined_q8_rom_uq3_0_to_uq1_12 rom_power (.a_i(power_index), .y_o(power_begin));
  blysk_power_pipelined_q8_rom_uq3_0_to_sqm3_12 rom_power_change (.a_i(power_index), .y_o(power_change));
  blysk_power_pipelined_q8_mul_sqm3_12_uq0_8_to_sqm3_20 mul_power (
      .a_i(power_change), .b_i(power_place), .p_o(power_product)
  );
  blysk_power_pipelined_q8_add_uq1_12_sqm3_20_to_uq1_20 add_power (
      .a_i(power_begin_9), .b_i(power_product_9), .carry_i(grounded), .s_o(power_line)
  );
  blysk_power_pipelined_q8_field_uq1_20_to_uq1_11_from_09 cut_power (.a_i(power_line), .y_o(power_of_fraction));
  blysk_power_pipelined_q8_shift_right_uq1_11_uq4_0_to_uq1_11 shift (
      .a_i(power_of_fraction), .places_i(places_10), .y_o(shifted)
  );
  blysk_power_pipelined_q8_quantise_uq1_11_to_uq1_8 quant (.a_i(shifted), .y_o(rounded));
  blysk_power_pipelined_q8_either_uq9_0 off (.a_i(above), .b_i(is_zero_7), .y_o(is_off));
  blysk_power_pipelined_q8_key_uq1_8 key_brdf (.a_i(rounded), .off_i(is_off_11), .y_o(brdf_first));

endmodule

`default_nettype wire
