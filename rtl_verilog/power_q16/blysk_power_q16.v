// SPDX-License-Identifier: Apache-2.0
// device power, format q16, 64 lines for the logarithm, 128 for the power of two, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:8cbca8136857404280257229a42fc9fd0fa956473221a411a0be27c6612ddf27
//   error against c^n, every code of the cosine: at most 1.27468e-05 (n = 933, c = 0.99993896484375), bias -1.29824e-08; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.00697416 (n = 1000, c = 0.9999930014352216), bias -2.79807e-07; 146779000 inputs, n in 1..1000, exhaustive
//   iCE40: 4096 LUT, 227 carry, 52 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 889 LUT, 94 carry, 52 FF, 9 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 10.58 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 11066.7 NAND2, 10858 cells, longest path 30.172 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: certificate, settling
`default_nettype none

module blysk_power_q16 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 15: write rg1
    input  wire [16:0] cos_i,  // 18: cos(delta), 0..1, UQ1.16, codes 0..65536
    input  wire cos_we_i,  // 17: write rg2, by its trailing edge
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire r_we_i,  // 20: write rg3
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire g_we_i,  // 22: write rg4
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire b_we_i,  // 24: write rg5
    output wire [23:0] r_o,  // 25: red, UQ8.16
    output wire [23:0] g_o,  // 26: green, UQ8.16
    output wire [23:0] b_o,  // 27: blue, UQ8.16
    output wire valid_o  // 29: 25..27 are valid at its leading edge
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [16:0] cos_delta;  // rg2: UQ1.16, codes 0..65536
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
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
  wire [16:0] brdf;  // key_brdf: UQ1.16, codes 0..65536

  blysk_power_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_power_q16_reg_trailing_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_power_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_power_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_power_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_power_q16_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_power_q16_constant_uq2_0 #(.RAW(2'd2)) node2 (.y_o(two));  // 2
  blysk_power_q16_constant_uq1_0 #(.RAW(1'd1)) carry_f (.y_o(carry_one));  // 1
  blysk_power_q16_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_power_q16_normalise_uq1_16_to_uq2_15_uq4_0 norm (
      .a_i(cos_delta), .m_o(normalised), .zeros_o(zeros), .zero_o(is_zero)
  );
  blysk_power_q16_inverter_bank_uq2_15_to_sq2_15 inv_f (.a_i(normalised), .y_o(inverted));
  blysk_power_q16_add_uq2_0_sq2_15_to_uq1_15 add_f (
      .a_i(two), .b_i(inverted), .carry_i(carry_one), .s_o(distance)
  );
  blysk_power_q16_field_uq2_15_to_uq6_0_from_09 index_ratio (.a_i(normalised), .y_o(ratio_index));
  blysk_power_q16_field_uq2_15_to_uq0_9_from_00 place_ratio (.a_i(normalised), .y_o(ratio_place));
  blysk_power_q16_rom_uq6_0_to_uq1_20 rom_ratio (.a_i(ratio_index), .y_o(ratio_begin));
  blysk_power_q16_rom_uq6_0_to_sqm7_20 rom_ratio_change (.a_i(ratio_index), .y_o(ratio_change));
  blysk_power_q16_mul_sqm7_20_uq0_9_to_sqm7_29 mul_ratio (
      .a_i(ratio_change), .b_i(ratio_place), .p_o(ratio_product)
  );
  blysk_power_q16_add_uq1_20_sqm7_29_to_uq1_29 add_ratio (
      .a_i(ratio_begin), .b_i(ratio_product), .carry_i(grounded), .s_o(ratio_line)
  );
  blysk_power_q16_field_uq1_29_to_uq1_19_from_10 cut_ratio (.a_i(ratio_line), .y_o(ratio));
  blysk_power_q16_mul_uq1_15_uq1_19_to_uq2_34 mul_log (.a_i(distance), .b_i(ratio), .p_o(log_product));
  blysk_power_q16_field_uq2_34_to_uq1_28_from_06 cut_log (.a_i(log_product), .y_o(log_fraction));
  blysk_power_q16_add_uq4_0_uq1_28_to_uq4_28 add_log (
      .a_i(zeros), .b_i(log_fraction), .carry_i(grounded), .s_o(minus_log_cos)
  );
  blysk_power_q16_mul_uq10_0_uq4_28_to_uq14_28 mul_n (.a_i(n), .b_i(minus_log_cos), .p_o(minus_log_power));
  blysk_power_q16_field_uq14_28_to_uq9_0_from_33 cut_above (.a_i(minus_log_power), .y_o(above));
  blysk_power_q16_field_uq14_28_to_uq5_0_from_28 cut_places (.a_i(minus_log_power), .y_o(places));
  blysk_power_q16_field_uq14_28_to_uq7_0_from_21 index_power (.a_i(minus_log_power), .y_o(power_index));
  blysk_power_q16_field_uq14_28_to_uq0_12_from_09 place_power (.a_i(minus_log_power), .y_o(power_place));
  blysk_power_q16_rom_uq7_0_to_uq1_20 rom_power (.a_i(power_index), .y_o(power_begin));
  blysk_power_q16_rom_uq7_0_to_sqm7_20 rom_power_change (.a_i(power_index), .y_o(power_change));
  blysk_power_q16_mul_sqm7_20_uq0_12_to_sqm7_32 mul_power (
      .a_i(power_change), .b_i(power_place), .p_o(power_product)
  );
  blysk_power_q16_add_uq1_20_sqm7_32_to_uq1_32 add_power (
      .a_i(power_begin), .b_i(power_product), .carry_i(grounded), .s_o(power_line)
  );
  blysk_power_q16_field_uq1_32_to_uq1_19_from_13 cut_power (.a_i(power_line), .y_o(power_of_fraction));
  blysk_power_q16_shift_right_uq1_19_uq5_0_to_uq1_19 shift (
      .a_i(power_of_fraction), .places_i(places), .y_o(shifted)
  );
  blysk_power_q16_quantise_uq1_19_to_uq1_16 quant (.a_i(shifted), .y_o(rounded));
  blysk_power_q16_either_uq9_0 off (.a_i(above), .b_i(is_zero), .y_o(is_off));
  blysk_power_q16_key_uq1_16 key_brdf (.a_i(rounded), .off_i(is_off), .y_o(brdf));
  blysk_power_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_power_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_power_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
