// SPDX-License-Identifier: Apache-2.0
// device power, format q8, 4 lines for the logarithm, 8 for the power of two, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:6206d9888900b1cb2f3ffdc32d7d58b8dec148b2fdb8822172e60acc859a4de3
//   error against c^n, every code of the cosine: at most 0.00283121 (n = 143, c = 0.99609375), bias -3.03979e-06; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias 0.00120978; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.0035 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0028312142333930534 seen, 257000 inputs, exhaustive
//   iCE40: 1585 LUT, 130 carry, 44 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 139 LUT, 40 carry, 44 FF, 8 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 14.95 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 4635.2 NAND2, 4498 cells, longest path 21.937 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 23.751 ns in OSU018 with its blocks apart, 23.24 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_power_q8 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 15: write rg1
    input  wire [8:0] cos_i,  // 18: cos(delta), 0..1, UQ1.8, codes 0..256
    input  wire cos_we_i,  // 17: write rg2, by its trailing edge
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire r_we_i,  // 20: write rg3
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire g_we_i,  // 22: write rg4
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire b_we_i,  // 24: write rg5
    output wire [15:0] r_o,  // 25: red, UQ8.8
    output wire [15:0] g_o,  // 26: green, UQ8.8
    output wire [15:0] b_o,  // 27: blue, UQ8.8
    output wire valid_o  // 29: 25..27 are valid at its leading edge
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [8:0] cos_delta;  // rg2: UQ1.8, codes 0..256
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
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
  wire [8:0] brdf;  // key_brdf: UQ1.8, codes 0..256

  blysk_power_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_power_q8_reg_trailing_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_power_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_power_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_power_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_power_q8_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_power_q8_constant_uq2_0 #(.RAW(2'd2)) node2 (.y_o(two));  // 2
  blysk_power_q8_constant_uq1_0 #(.RAW(1'd1)) carry_f (.y_o(carry_one));  // 1
  blysk_power_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_power_q8_normalise_uq1_8_to_uq2_7_uq3_0 norm (
      .a_i(cos_delta), .m_o(normalised), .zeros_o(zeros), .zero_o(is_zero)
  );
  blysk_power_q8_inverter_bank_uq2_7_to_sq2_7 inv_f (.a_i(normalised), .y_o(inverted));
  blysk_power_q8_add_uq2_0_sq2_7_to_uq1_7 add_f (
      .a_i(two), .b_i(inverted), .carry_i(carry_one), .s_o(distance)
  );
  blysk_power_q8_field_uq2_7_to_uq2_0_from_05 index_ratio (.a_i(normalised), .y_o(ratio_index));
  blysk_power_q8_field_uq2_7_to_uq0_5_from_00 place_ratio (.a_i(normalised), .y_o(ratio_place));
  blysk_power_q8_rom_uq2_0_to_uq1_12 rom_ratio (.a_i(ratio_index), .y_o(ratio_begin));
  blysk_power_q8_rom_uq2_0_to_sqm3_12 rom_ratio_change (.a_i(ratio_index), .y_o(ratio_change));
  blysk_power_q8_mul_sqm3_12_uq0_5_to_sqm3_17 mul_ratio (
      .a_i(ratio_change), .b_i(ratio_place), .p_o(ratio_product)
  );
  blysk_power_q8_add_uq1_12_sqm3_17_to_uq1_17 add_ratio (
      .a_i(ratio_begin), .b_i(ratio_product), .carry_i(grounded), .s_o(ratio_line)
  );
  blysk_power_q8_field_uq1_17_to_uq1_11_from_06 cut_ratio (.a_i(ratio_line), .y_o(ratio));
  blysk_power_q8_mul_uq1_7_uq1_11_to_uq2_18 mul_log (.a_i(distance), .b_i(ratio), .p_o(log_product));
  blysk_power_q8_field_uq2_18_to_uq1_17_from_01 cut_log (.a_i(log_product), .y_o(log_fraction));
  blysk_power_q8_add_uq3_0_uq1_17_to_uq3_17 add_log (
      .a_i(zeros), .b_i(log_fraction), .carry_i(grounded), .s_o(minus_log_cos)
  );
  blysk_power_q8_mul_uq10_0_uq3_17_to_uq13_17 mul_n (.a_i(n), .b_i(minus_log_cos), .p_o(minus_log_power));
  blysk_power_q8_field_uq13_17_to_uq9_0_from_21 cut_above (.a_i(minus_log_power), .y_o(above));
  blysk_power_q8_field_uq13_17_to_uq4_0_from_17 cut_places (.a_i(minus_log_power), .y_o(places));
  blysk_power_q8_field_uq13_17_to_uq3_0_from_14 index_power (.a_i(minus_log_power), .y_o(power_index));
  blysk_power_q8_field_uq13_17_to_uq0_8_from_06 place_power (.a_i(minus_log_power), .y_o(power_place));
  blysk_power_q8_rom_uq3_0_to_uq1_12 rom_power (.a_i(power_index), .y_o(power_begin));
  blysk_power_q8_rom_uq3_0_to_sqm3_12 rom_power_change (.a_i(power_index), .y_o(power_change));
  blysk_power_q8_mul_sqm3_12_uq0_8_to_sqm3_20 mul_power (
      .a_i(power_change), .b_i(power_place), .p_o(power_product)
  );
  blysk_power_q8_add_uq1_12_sqm3_20_to_uq1_20 add_power (
      .a_i(power_begin), .b_i(power_product), .carry_i(grounded), .s_o(power_line)
  );
  blysk_power_q8_field_uq1_20_to_uq1_11_from_09 cut_power (.a_i(power_line), .y_o(power_of_fraction));
  blysk_power_q8_shift_right_uq1_11_uq4_0_to_uq1_11 shift (
      .a_i(power_of_fraction), .places_i(places), .y_o(shifted)
  );
  blysk_power_q8_quantise_uq1_11_to_uq1_8 quant (.a_i(shifted), .y_o(rounded));
  blysk_power_q8_either_uq9_0 off (.a_i(above), .b_i(is_zero), .y_o(is_off));
  blysk_power_q8_key_uq1_8 key_brdf (.a_i(rounded), .off_i(is_off), .y_o(brdf));
  blysk_power_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_power_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_power_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
