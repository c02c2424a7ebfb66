// SPDX-License-Identifier: Apache-2.0
// device gx, format q12, a combinational divider, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^2 / (c^2 + n (1 - c^2)/2), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:57d5da634d2151b9c7664f3ffb6ae71ddfac0d960b7088a7d71dcfe0f4be5796
//   error against c^n, every code of the cosine: at most 0.203193 (n = 928, c = 0.997314453125), bias 0.0117756; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.213657 (n = 995, c = 0.9976842579877792), bias 0.0216458; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.000122071 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0001220703125 seen, 4097000 inputs, exhaustive
//   iCE40: 3474 LUT, 981 carry, 48 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 1866 LUT, 926 carry, 48 FF, 6 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 6.22 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 10093.7 NAND2, 9549 cells, longest path 55.918 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 46.817 ns in OSU018 with its blocks apart, 46.366 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_gx_q12 (
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
  wire grounded;  // ground: UQ1.0
  wire [24:0] square;  // mul_cos: UQ1.24, codes 0..16777216
  wire [24:0] rest;  // sub_square: UQ1.24, codes 0..16777216
  wire [9:0] half_n;  // halve_n: UQ9.1
  wire [33:0] drop;  // mul_n: UQ9.25
  wire [33:0] divisor;  // add_divisor: UQ9.25
  wire [13:0] quotient;  // div: UQ1.13, codes 0..8192
  wire [12:0] brdf;  // quant: UQ1.12, codes 0..4096

  blysk_gx_q12_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_gx_q12_reg_trailing_uq1_12 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_gx_q12_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_gx_q12_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_gx_q12_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_gx_q12_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_gx_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_gx_q12_mul_uq1_12_uq1_12_to_uq1_24 mul_cos (.a_i(cos_delta), .b_i(cos_delta), .p_o(square));
  blysk_gx_q12_one_minus_uq1_24 sub_square (.a_i(square), .y_o(rest));
  blysk_gx_q12_move_point_uq10_0_to_uq9_1 halve_n (.a_i(n), .y_o(half_n));
  blysk_gx_q12_mul_uq9_1_uq1_24_to_uq9_25 mul_n (.a_i(half_n), .b_i(rest), .p_o(drop));
  blysk_gx_q12_add_uq9_25_uq1_24_to_uq9_25 add_divisor (
      .a_i(drop), .b_i(square), .carry_i(grounded), .s_o(divisor)
  );
  blysk_gx_q12_divide_uq1_24_uq9_25_to_uq1_13 div (.a_i(square), .b_i(divisor), .q_o(quotient));
  blysk_gx_q12_quantise_uq1_13_to_uq1_12 quant (.a_i(quotient), .y_o(brdf));
  blysk_gx_q12_mul_uq1_12_uq8_0_to_uq8_12 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_gx_q12_mul_uq1_12_uq8_0_to_uq8_12 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_gx_q12_mul_uq1_12_uq8_0_to_uq8_12 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
