// SPDX-License-Identifier: Apache-2.0
// device cosine-quadratic, format q16, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = (m (c - 1) + 1)^2, 0 where the line is negative, m = (n + 1)/3, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:84075a8b14af107b1b4eb5e3024e1481a80ea711588d01d292a04be1f322c793
//   error against c^n, every code of the cosine: at most 0.111115 (n = 1, c = 0), bias -1.85223e-05; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.100967 (n = 1, c = 0.018539761437612663), bias 3.83624e-05; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 1.31926e-05 of what it computes in real numbers, proved by Gappa 1.4.1; at most 1.2348509497217552e-05 seen, 65537000 inputs, exhaustive
//   iCE40: 3150 LUT, 177 carry, 52 FF, 0 DSP, 28672 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 325 LUT, 192 carry, 52 FF, 8 DSP, 28672 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 18.41 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 8845.6 NAND2, 8586 cells, longest path 18.795 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_cosine_quadratic_q16 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 17: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 18: write rg2
    input  wire [16:0] cos_i,  // 32: cos(gamma), 0..1, UQ1.16, codes 0..65536
    input  wire cos_we_i,  // write rg1, by its trailing edge
    input  wire [7:0] r_i,  // R k_s, UQ8.0
    input  wire r_we_i,  // write rg3
    input  wire [7:0] g_i,  // G k_s, UQ8.0
    input  wire g_we_i,  // write rg4
    input  wire [7:0] b_i,  // B k_s, UQ8.0
    input  wire b_we_i,  // write rg5
    output wire [23:0] r_o,  // red, UQ8.16
    output wire [23:0] g_o,  // green, UQ8.16
    output wire [23:0] b_o,  // blue, UQ8.16
    output wire valid_o  // the colours are valid at its leading edge
);

  wire [9:0] n;  // rg2: UQ10.0, codes 1..1000
  wire [16:0] cos_delta;  // rg1: UQ1.16, codes 0..65536
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire signed minus_one;  // ones6: SQ0.0
  wire grounded;  // ground: UQ1.0
  wire carry29_in;  // carry29: UQ1.0
  wire [24:0] slope;  // rom33: UQ9.16
  wire signed [16:0] cos_minus_1;  // add6: SQ0.16
  wire signed [41:0] product;  // mul7: SQ9.32
  wire signed [41:0] line;  // add8: SQ9.32
  wire signed [20:0] line_rounded;  // quant8: SQ1.19, codes -524288..524288
  wire [16:0] square;  // mul10: UQ1.16, codes 0..65536
  wire beyond_root;
  wire [16:0] brdf;  // key12: UQ1.16, codes 0..65536

  blysk_cosine_quadratic_q16_reg_level_uq10_0 rg2 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_cosine_quadratic_q16_reg_trailing_uq1_16 rg1 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_cosine_quadratic_q16_reg_level_uq8_0 rg3 (
      .clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks)
  );
  blysk_cosine_quadratic_q16_reg_level_uq8_0 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks)
  );
  blysk_cosine_quadratic_q16_reg_level_uq8_0 rg5 (
      .clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks)
  );
  blysk_cosine_quadratic_q16_buffer buf_valid (.a_i(cos_we_i), .y_o(valid_o));
  blysk_cosine_quadratic_q16_constant_sq0_0 #(.RAW(1'd1)) ones6 (.y_o(minus_one));  // -1
  blysk_cosine_quadratic_q16_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_cosine_quadratic_q16_constant_uq1_0 #(.RAW(1'd1)) carry29 (.y_o(carry29_in));  // 1
  blysk_cosine_quadratic_q16_rom_uq10_0_to_uq9_16 rom33 (.a_i(n), .y_o(slope));
  blysk_cosine_quadratic_q16_add_uq1_16_sq0_0_to_sq0_16 add6 (
      .a_i(cos_delta), .b_i(minus_one), .carry_i(grounded), .s_o(cos_minus_1)
  );
  blysk_cosine_quadratic_q16_mul_uq9_16_sq0_16_to_sq9_32 mul7 (.a_i(slope), .b_i(cos_minus_1), .p_o(product));
  blysk_cosine_quadratic_q16_add_sq9_32_uq1_0_to_sq9_32_unity_carry add8 (
      .a_i(product), .b_i(grounded), .carry_i(carry29_in), .s_o(line)
  );
  blysk_cosine_quadratic_q16_quantise_sq9_32_to_sq1_19_clamp quant8 (.a_i(line), .y_o(line_rounded));
  blysk_cosine_quadratic_q16_mul_sq1_19_sq1_19_to_uq1_16 mul10 (
      .a_i(line_rounded), .b_i(line_rounded), .p_o(square)
  );
  blysk_cosine_quadratic_q16_sign_sq9_32 sign8 (.a_i(line), .negative_o(beyond_root));
  blysk_cosine_quadratic_q16_key_uq1_16 key12 (.a_i(square), .off_i(beyond_root), .y_o(brdf));
  blysk_cosine_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul_red (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_cosine_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul_green (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_cosine_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul_blue (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
