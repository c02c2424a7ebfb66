// SPDX-License-Identifier: Apache-2.0
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = e^-t, 0 from t = 8 on, t = n (1 - c) (1 + (1 - c)/2), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:5b0b35c44dfbcd5736019f1453f6dd3d1fd5916d963a47174a18700e612d9153
//   error against c^n, every code of the cosine: at most 0.222656 (n = 1, c = 0), bias 0.000145139; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias 0.00130017; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.00231906 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0021635809316357113 seen, 257000 inputs, exhaustive
//   iCE40: 1484 LUT, 105 carry, 44 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 357 LUT, 48 carry, 44 FF, 7 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 17.49 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 4075.4 NAND2, 3877 cells, longest path 18.065 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 20.826 ns in OSU018 with its blocks apart, 20.804 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_table_q8 (
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
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [8:0] versine;  // sub_cos: UQ1.8, codes 0..256
  wire [8:0] half_versine;  // halve_versine: UQ0.9
  wire [9:0] factor;  // add_factor: UQ1.9
  wire [17:0] log_of_cos;  // mul_log: UQ1.17
  wire [27:0] power_log;  // mul_n: UQ11.17
  wire [14:0] limited;  // quant_log: UQ3.12
  wire [7:0] index;  // cut_index: UQ8.0
  wire [6:0] place;  // cut_place: UQ0.7
  wire [11:0] line_begin;  // rom_begin: UQ1.11
  wire signed [6:0] line_change;  // rom_change: SQ-5.11
  wire signed [13:0] change_there;  // mul_place: SQ-5.18
  wire [18:0] line;  // add_line: UQ1.18, codes 0..262144
  wire [8:0] brdf;  // quant: UQ1.8, codes 0..256

  blysk_table_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_table_q8_reg_trailing_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_table_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_table_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_table_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_table_q8_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_table_q8_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_table_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_table_q8_one_minus_uq1_8 sub_cos (.a_i(cos_delta), .y_o(versine));
  blysk_table_q8_move_point_uq1_8_to_uq0_9 halve_versine (.a_i(versine), .y_o(half_versine));
  blysk_table_q8_add_uq1_0_uq0_9_to_uq1_9 add_factor (
      .a_i(unity), .b_i(half_versine), .carry_i(grounded), .s_o(factor)
  );
  blysk_table_q8_mul_uq1_8_uq1_9_to_uq1_17 mul_log (.a_i(versine), .b_i(factor), .p_o(log_of_cos));
  blysk_table_q8_mul_uq10_0_uq1_17_to_uq11_17 mul_n (.a_i(n), .b_i(log_of_cos), .p_o(power_log));
  blysk_table_q8_quantise_uq11_17_to_uq3_12_clamp quant_log (.a_i(power_log), .y_o(limited));
  blysk_table_q8_field_uq3_12_to_uq8_0_from_07 cut_index (.a_i(limited), .y_o(index));
  blysk_table_q8_field_uq3_12_to_uq0_7_from_00 cut_place (.a_i(limited), .y_o(place));
  blysk_table_q8_rom_uq8_0_to_uq1_11 rom_begin (.a_i(index), .y_o(line_begin));
  blysk_table_q8_rom_uq8_0_to_sqm5_11 rom_change (.a_i(index), .y_o(line_change));
  blysk_table_q8_mul_sqm5_11_uq0_7_to_sqm5_18 mul_place (.a_i(line_change), .b_i(place), .p_o(change_there));
  blysk_table_q8_add_uq1_11_sqm5_18_to_uq1_18 add_line (
      .a_i(line_begin), .b_i(change_there), .carry_i(grounded), .s_o(line)
  );
  blysk_table_q8_quantise_uq1_18_to_uq1_8 quant (.a_i(line), .y_o(brdf));
  blysk_table_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_table_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_table_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
