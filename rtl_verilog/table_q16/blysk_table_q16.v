// SPDX-License-Identifier: Apache-2.0
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = e^-t, 0 from t = 8 on, t = n (1 - c) (1 + (1 - c)/2), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:9103e678f084362339d1e2db6634635adf70d8b91516d521219e9c3672ae18e6
//   error against c^n, every code of the cosine: at most 0.223129 (n = 1, c = 0), bias 0.000148226; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.212997 (n = 1, c = 0.018539761437612663), bias 9.10508e-05; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.000345435 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0003356930998373394 seen, 65537000 inputs, exhaustive
//   iCE40: 3693 LUT, 176 carry, 52 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 1001 LUT, 154 carry, 52 FF, 8 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 13.03 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 9504.4 NAND2, 9210 cells, longest path 23.396 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_table_q16 (
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
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [16:0] versine;  // sub_cos: UQ1.16, codes 0..65536
  wire [16:0] half_versine;  // halve_versine: UQ0.17
  wire [17:0] factor;  // add_factor: UQ1.17
  wire [28:0] log_of_cos;  // mul_log: UQ1.28
  wire [38:0] power_log;  // mul_n: UQ11.28
  wire [22:0] limited;  // quant_log: UQ3.20
  wire [7:0] index;  // cut_index: UQ8.0
  wire [14:0] place;  // cut_place: UQ0.15
  wire [19:0] line_begin;  // rom_begin: UQ1.19
  wire signed [14:0] line_change;  // rom_change: SQ-5.19
  wire signed [29:0] change_there;  // mul_place: SQ-5.34
  wire [34:0] line;  // add_line: UQ1.34, codes 0..17179869184
  wire [16:0] brdf;  // quant: UQ1.16, codes 0..65536

  blysk_table_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_table_q16_reg_trailing_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_table_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_table_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_table_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_table_q16_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_table_q16_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_table_q16_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_table_q16_one_minus_uq1_16 sub_cos (.a_i(cos_delta), .y_o(versine));
  blysk_table_q16_move_point_uq1_16_to_uq0_17 halve_versine (.a_i(versine), .y_o(half_versine));
  blysk_table_q16_add_uq1_0_uq0_17_to_uq1_17 add_factor (
      .a_i(unity), .b_i(half_versine), .carry_i(grounded), .s_o(factor)
  );
  blysk_table_q16_mul_uq1_16_uq1_17_to_uq1_28 mul_log (.a_i(versine), .b_i(factor), .p_o(log_of_cos));
  blysk_table_q16_mul_uq10_0_uq1_28_to_uq11_28 mul_n (.a_i(n), .b_i(log_of_cos), .p_o(power_log));
  blysk_table_q16_quantise_uq11_28_to_uq3_20_clamp quant_log (.a_i(power_log), .y_o(limited));
  blysk_table_q16_field_uq3_20_to_uq8_0_from_15 cut_index (.a_i(limited), .y_o(index));
  blysk_table_q16_field_uq3_20_to_uq0_15_from_00 cut_place (.a_i(limited), .y_o(place));
  blysk_table_q16_rom_uq8_0_to_uq1_19 rom_begin (.a_i(index), .y_o(line_begin));
  blysk_table_q16_rom_uq8_0_to_sqm5_19 rom_change (.a_i(index), .y_o(line_change));
  blysk_table_q16_mul_sqm5_19_uq0_15_to_sqm5_34 mul_place (.a_i(line_change), .b_i(place), .p_o(change_there));
  blysk_table_q16_add_uq1_19_sqm5_34_to_uq1_34 add_line (
      .a_i(line_begin), .b_i(change_there), .carry_i(grounded), .s_o(line)
  );
  blysk_table_q16_quantise_uq1_34_to_uq1_16 quant (.a_i(line), .y_o(brdf));
  blysk_table_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_table_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_table_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
