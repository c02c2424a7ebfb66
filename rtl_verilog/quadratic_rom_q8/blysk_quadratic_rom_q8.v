// SPDX-License-Identifier: Apache-2.0
// device quadratic-rom, format q8, memory of 1000 words of 18 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, a (c^2 - c) + c), a = (t^(n-1) - 1)/(t - 1), t = sqrt((n-1)/n), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:5197a8cfd590388bc52766206c48767a4a660842d5aceacad0ba8c3790f0377c
//   error against c^n, every code of the cosine: at most 0.279171 (n = 326, c = 0.99609375), bias -0.00171006; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias -0.00217105; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.00244152 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0022248094117238576 seen, 257000 inputs, exhaustive
//   iCE40: 1260 LUT, 79 carry, 44 FF, 0 DSP, 20480 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 77 LUT, 46 carry, 44 FF, 6 DSP, 20480 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 25.84 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 5568.5 NAND2, 5328 cells, longest path 12.79 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 15.359 ns in OSU018 with its blocks apart, 15.359 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_quadratic_rom_q8 (
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
  wire carry28_in;  // carry28: UQ1.0
  wire carry30_in;  // carry30: UQ1.0
  wire [16:0] cos2;  // mul7: UQ1.16
  wire signed [17:0] cos_inv;  // inv8: SQ1.16
  wire signed [14:0] cos2_minus_cos;  // add9: SQ-2.16
  wire [17:0] a;  // rom6: UQ10.8
  wire signed [32:0] a_times_diff;  // mul10: SQ8.24
  wire signed [32:0] parabola;  // add11: SQ8.24
  wire [8:0] brdf;  // quant11: UQ1.8, codes 0..256

  blysk_quadratic_rom_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_quadratic_rom_q8_reg_trailing_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_quadratic_rom_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_quadratic_rom_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_quadratic_rom_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_quadratic_rom_q8_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_quadratic_rom_q8_constant_uq1_0 #(.RAW(1'd1)) carry28 (.y_o(carry28_in));  // 1
  blysk_quadratic_rom_q8_constant_uq1_0 #(.RAW(1'd0)) carry30 (.y_o(carry30_in));  // 0
  blysk_quadratic_rom_q8_mul_uq1_8_uq1_8_to_uq1_16 mul7 (.a_i(cos_delta), .b_i(cos_delta), .p_o(cos2));
  blysk_quadratic_rom_q8_inverter_bank_uq1_8_to_sq1_16 inv8 (.a_i(cos_delta), .y_o(cos_inv));
  blysk_quadratic_rom_q8_add_uq1_16_sq1_16_to_sqm2_16 add9 (
      .a_i(cos2), .b_i(cos_inv), .carry_i(carry28_in), .s_o(cos2_minus_cos)
  );
  blysk_quadratic_rom_q8_rom_uq10_0_to_uq10_8 rom6 (.a_i(n), .y_o(a));
  blysk_quadratic_rom_q8_mul_uq10_8_sqm2_16_to_sq8_24 mul10 (.a_i(a), .b_i(cos2_minus_cos), .p_o(a_times_diff));
  blysk_quadratic_rom_q8_add_sq8_24_uq1_8_to_sq8_24 add11 (
      .a_i(a_times_diff), .b_i(cos_delta), .carry_i(carry30_in), .s_o(parabola)
  );
  blysk_quadratic_rom_q8_quantise_sq8_24_to_uq1_8_clamp quant11 (.a_i(parabola), .y_o(brdf));
  blysk_quadratic_rom_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_quadratic_rom_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_quadratic_rom_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
