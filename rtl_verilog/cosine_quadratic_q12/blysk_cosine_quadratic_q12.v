// SPDX-License-Identifier: Apache-2.0
// device cosine-quadratic, format q12, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = (m (c - 1) + 1)^2, 0 where the line is negative, m = (n + 1)/3, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:a39f86b640fdd5525cd591555e74b224a8c374287e6bb15d0a8c35bd2437935c
//   error against c^n, every code of the cosine: at most 0.111084 (n = 1, c = 0), bias -1.934e-05; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.155161 (n = 1000, c = 0.999394173354759), bias 4.0879e-05; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.000211078 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.00019847022162550187 seen, 4097000 inputs, exhaustive
//   iCE40: 2146 LUT, 142 carry, 48 FF, 0 DSP, 24576 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 210 LUT, 111 carry, 48 FF, 6 DSP, 24576 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 19.69 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 6299 NAND2, 6041 cells, longest path 16.401 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 18.886 ns in OSU018 with its blocks apart, 18.886 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_cosine_quadratic_q12 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 17: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 18: write rg2
    input  wire [12:0] cos_i,  // 32: cos(gamma), 0..1, UQ1.12, codes 0..4096
    input  wire cos_we_i,  // write rg1, by its trailing edge
    input  wire [7:0] r_i,  // R k_s, UQ8.0
    input  wire r_we_i,  // write rg3
    input  wire [7:0] g_i,  // G k_s, UQ8.0
    input  wire g_we_i,  // write rg4
    input  wire [7:0] b_i,  // B k_s, UQ8.0
    input  wire b_we_i,  // write rg5
    output wire [19:0] r_o,  // red, UQ8.12
    output wire [19:0] g_o,  // green, UQ8.12
    output wire [19:0] b_o,  // blue, UQ8.12
    output wire valid_o  // the colours are valid at its leading edge
);

  wire [9:0] n;  // rg2: UQ10.0, codes 1..1000
  wire [12:0] cos_delta;  // rg1: UQ1.12, codes 0..4096
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire signed minus_one;  // ones6: SQ0.0
  wire grounded;  // ground: UQ1.0
  wire carry29_in;  // carry29: UQ1.0
  wire [20:0] slope;  // rom33: UQ9.12
  wire signed [12:0] cos_minus_1;  // add6: SQ0.12
  wire signed [33:0] product;  // mul7: SQ9.24
  wire signed [33:0] line;  // add8: SQ9.24
  wire signed [16:0] line_rounded;  // quant8: SQ1.15, codes -32768..32768
  wire [12:0] square;  // mul10: UQ1.12, codes 0..4096
  wire beyond_root;
  wire [12:0] brdf;  // key12: UQ1.12, codes 0..4096

  blysk_cosine_quadratic_q12_reg_level_uq10_0 rg2 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_cosine_quadratic_q12_reg_trailing_uq1_12 rg1 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_cosine_quadratic_q12_reg_level_uq8_0 rg3 (
      .clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks)
  );
  blysk_cosine_quadratic_q12_reg_level_uq8_0 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks)
  );
  blysk_cosine_quadratic_q12_reg_level_uq8_0 rg5 (
      .clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks)
  );
  blysk_cosine_quadratic_q12_buffer buf_valid (.a_i(cos_we_i), .y_o(valid_o));
  blysk_cosine_quadratic_q12_constant_sq0_0 #(.RAW(1'd1)) ones6 (.y_o(minus_one));  // -1
  blysk_cosine_quadratic_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_cosine_quadratic_q12_constant_uq1_0 #(.RAW(1'd1)) carry29 (.y_o(carry29_in));  // 1
  blysk_cosine_quadratic_q12_rom_uq10_0_to_uq9_12 rom33 (.a_i(n), .y_o(slope));
  blysk_cosine_quadratic_q12_add_uq1_12_sq0_0_to_sq0_12 add6 (
      .a_i(cos_delta), .b_i(minus_one), .carry_i(grounded), .s_o(cos_minus_1)
  );
  blysk_cosine_quadratic_q12_mul_uq9_12_sq0_12_to_sq9_24 mul7 (.a_i(slope), .b_i(cos_minus_1), .p_o(product));
  blysk_cosine_quadratic_q12_add_sq9_24_uq1_0_to_sq9_24_unity_carry add8 (
      .a_i(product), .b_i(grounded), .carry_i(carry29_in), .s_o(line)
  );
  blysk_cosine_quadratic_q12_quantise_sq9_24_to_sq1_15_clamp quant8 (.a_i(line), .y_o(line_rounded));
  blysk_cosine_quadratic_q12_mul_sq1_15_sq1_15_to_uq1_12 mul10 (
      .a_i(line_rounded), .b_i(line_rounded), .p_o(square)
  );
  blysk_cosine_quadratic_q12_sign_sq9_24 sign8 (.a_i(line), .negative_o(beyond_root));
  blysk_cosine_quadratic_q12_key_uq1_12 key12 (.a_i(square), .off_i(beyond_root), .y_o(brdf));
  blysk_cosine_quadratic_q12_mul_uq1_12_uq8_0_to_uq8_12 mul_red (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_cosine_quadratic_q12_mul_uq1_12_uq8_0_to_uq8_12 mul_green (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_cosine_quadratic_q12_mul_uq1_12_uq8_0_to_uq8_12 mul_blue (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
