// SPDX-License-Identifier: Apache-2.0
// device power, format q12, 16 lines for the logarithm, 32 for the power of two, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:d4eb812a9d90b3c51132f5d7b60804a20679d3ed97d325c966454bfa99d5b8e2
//   error against c^n, every code of the cosine: at most 0.000188697 (n = 482, c = 0.999755859375), bias -2.73016e-07; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.112524 (n = 1000, c = 0.9998806334991259), bias 3.91938e-06; 146779000 inputs, n in 1..1000, exhaustive
//   iCE40: 2609 LUT, 179 carry, 48 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 283 LUT, 57 carry, 48 FF, 8 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 12.99 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 7454.7 NAND2, 7287 cells, longest path 26.558 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 28.977 ns in OSU018 with its blocks apart, 28.626 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: certificate
`default_nettype none

module blysk_power_q12 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 15: write rg1
    input  wire [12:0] cos_i,  // 18: cos(delta), 0..1, UQ1.12, codes 0..4096
    input  wire cos_we_i,  // 17: write rg2, by its trailing edge
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire r_we_i,  // 20: write rg3
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire g_we_i,  // 22: write rg4
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire b_we_i,  // 24: write rg5
    output wire [19:0] r_o,  // 25: red, UQ8.12
    output wire [19:0] g_o,  // 26: green, UQ8.12
    output wire [19:0] b_o,  // 27: blue, UQ8.12
    output wire valid_o  // 29: 25..27 are valid at its leading edge
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [12:0] cos_delta;  // rg2: UQ1.12, codes 0..4096
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [1:0] two;  // node2: UQ2.0
  wire carry_one;  // carry_f: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [12:0] normalised;  // norm: UQ2.11
  wire [3:0] zeros;  // norm: UQ4.0
  wire is_zero;
  wire signed [13:0] inverted;  // inv_f: SQ2.11
  wire [11:0] distance;  // add_f: UQ1.11, codes 0..2048
  wire [3:0] ratio_index;  // index_ratio: UQ4.0
  wire [6:0] ratio_place;  // place_ratio: UQ0.7
  wire [16:0] ratio_begin;  // rom_ratio: UQ1.16
  wire signed [11:0] ratio_change;  // rom_ratio_change: SQ-5.16
  wire signed [18:0] ratio_product;  // mul_ratio: SQ-5.23
  wire [23:0] ratio_line;  // add_ratio: UQ1.23
  wire [15:0] ratio;  // cut_ratio: UQ1.15
  wire [27:0] log_product;  // mul_log: UQ2.26
  wire [24:0] log_fraction;  // cut_log: UQ1.24
  wire [27:0] minus_log_cos;  // add_log: UQ4.24
  wire [37:0] minus_log_power;  // mul_n: UQ14.24
  wire [9:0] above;  // cut_above: UQ10.0
  wire [3:0] places;  // cut_places: UQ4.0
  wire [4:0] power_index;  // index_power: UQ5.0
  wire [9:0] power_place;  // place_power: UQ0.10
  wire [16:0] power_begin;  // rom_power: UQ1.16
  wire signed [11:0] power_change;  // rom_power_change: SQ-5.16
  wire signed [21:0] power_product;  // mul_power: SQ-5.26
  wire [26:0] power_line;  // add_power: UQ1.26
  wire [15:0] power_of_fraction;  // cut_power: UQ1.15
  wire [15:0] shifted;  // shift: UQ1.15
  wire [12:0] rounded;  // quant: UQ1.12, codes 0..4096
  wire is_off;
  wire [12:0] brdf;  // key_brdf: UQ1.12, codes 0..4096

  blysk_power_q12_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_power_q12_reg_trailing_uq1_12 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_power_q12_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_power_q12_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_power_q12_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_power_q12_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_power_q12_constant_uq2_0 #(.RAW(2'd2)) node2 (.y_o(two));  // 2
  blysk_power_q12_constant_uq1_0 #(.RAW(1'd1)) carry_f (.y_o(carry_one));  // 1
  blysk_power_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_power_q12_normalise_uq1_12_to_uq2_11_uq4_0 norm (
      .a_i(cos_delta), .m_o(normalised), .zeros_o(zeros), .zero_o(is_zero)
  );
  blysk_power_q12_inverter_bank_uq2_11_to_sq2_11 inv_f (.a_i(normalised), .y_o(inverted));
  blysk_power_q12_add_uq2_0_sq2_11_to_uq1_11 add_f (
      .a_i(two), .b_i(inverted), .carry_i(carry_one), .s_o(distance)
  );
  blysk_power_q12_field_uq2_11_to_uq4_0_from_07 index_ratio (.a_i(normalised), .y_o(ratio_index));
  blysk_power_q12_field_uq2_11_to_uq0_7_from_00 place_ratio (.a_i(normalised), .y_o(ratio_place));
  blysk_power_q12_rom_uq4_0_to_uq1_16 rom_ratio (.a_i(ratio_index), .y_o(ratio_begin));
  blysk_power_q12_rom_uq4_0_to_sqm5_16 rom_ratio_change (.a_i(ratio_index), .y_o(ratio_change));
  blysk_power_q12_mul_sqm5_16_uq0_7_to_sqm5_23 mul_ratio (
      .a_i(ratio_change), .b_i(ratio_place), .p_o(ratio_product)
  );
  blysk_power_q12_add_uq1_16_sqm5_23_to_uq1_23 add_ratio (
      .a_i(ratio_begin), .b_i(ratio_product), .carry_i(grounded), .s_o(ratio_line)
  );
  blysk_power_q12_field_uq1_23_to_uq1_15_from_08 cut_ratio (.a_i(ratio_line), .y_o(ratio));
  blysk_power_q12_mul_uq1_11_uq1_15_to_uq2_26 mul_log (.a_i(distance), .b_i(ratio), .p_o(log_product));
  blysk_power_q12_field_uq2_26_to_uq1_24_from_02 cut_log (.a_i(log_product), .y_o(log_fraction));
  blysk_power_q12_add_uq4_0_uq1_24_to_uq4_24 add_log (
      .a_i(zeros), .b_i(log_fraction), .carry_i(grounded), .s_o(minus_log_cos)
  );
  blysk_power_q12_mul_uq10_0_uq4_24_to_uq14_24 mul_n (.a_i(n), .b_i(minus_log_cos), .p_o(minus_log_power));
  blysk_power_q12_field_uq14_24_to_uq10_0_from_28 cut_above (.a_i(minus_log_power), .y_o(above));
  blysk_power_q12_field_uq14_24_to_uq4_0_from_24 cut_places (.a_i(minus_log_power), .y_o(places));
  blysk_power_q12_field_uq14_24_to_uq5_0_from_19 index_power (.a_i(minus_log_power), .y_o(power_index));
  blysk_power_q12_field_uq14_24_to_uq0_10_from_09 place_power (.a_i(minus_log_power), .y_o(power_place));
  blysk_power_q12_rom_uq5_0_to_uq1_16 rom_power (.a_i(power_index), .y_o(power_begin));
  blysk_power_q12_rom_uq5_0_to_sqm5_16 rom_power_change (.a_i(power_index), .y_o(power_change));
  blysk_power_q12_mul_sqm5_16_uq0_10_to_sqm5_26 mul_power (
      .a_i(power_change), .b_i(power_place), .p_o(power_product)
  );
  blysk_power_q12_add_uq1_16_sqm5_26_to_uq1_26 add_power (
      .a_i(power_begin), .b_i(power_product), .carry_i(grounded), .s_o(power_line)
  );
  blysk_power_q12_field_uq1_26_to_uq1_15_from_11 cut_power (.a_i(power_line), .y_o(power_of_fraction));
  blysk_power_q12_shift_right_uq1_15_uq4_0_to_uq1_15 shift (
      .a_i(power_of_fraction), .places_i(places), .y_o(shifted)
  );
  blysk_power_q12_quantise_uq1_15_to_uq1_12 quant (.a_i(shifted), .y_o(rounded));
  blysk_power_q12_either_uq10_0 off (.a_i(above), .b_i(is_zero), .y_o(is_off));
  blysk_power_q12_key_uq1_12 key_brdf (.a_i(rounded), .off_i(is_off), .y_o(brdf));
  blysk_power_q12_mul_uq1_12_uq8_0_to_uq8_12 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_power_q12_mul_uq1_12_uq8_0_to_uq8_12 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_power_q12_mul_uq1_12_uq8_0_to_uq8_12 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
