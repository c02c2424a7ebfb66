// SPDX-License-Identifier: Apache-2.0
// device quadratic-rom, format q12, memory of 1000 words of 22 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, a (c^2 - c) + c), a = (t^(n-1) - 1)/(t - 1), t = sqrt((n-1)/n), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:f7bec1bd4a42e5c397b474d851661c25a855850e386dd3e01c68c013689a5c11
//   error against c^n, every code of the cosine: at most 0.27991 (n = 868, c = 0.99853515625), bias -0.00179989; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.308552 (n = 868, c = 0.9986471440712392), bias -0.00355862; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.000152596 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.00014268198210146132 seen, 4097000 inputs, exhaustive
//   iCE40: 2325 LUT, 113 carry, 48 FF, 0 DSP, 24576 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 119 LUT, 90 carry, 48 FF, 8 DSP, 24576 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 21.46 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 9101.2 NAND2, 8841 cells, longest path 15.869 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 19.088 ns in OSU018 with its blocks apart, 19.088 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_quadratic_rom_q12 (
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
  wire carry28_in;  // carry28: UQ1.0
  wire carry30_in;  // carry30: UQ1.0
  wire [24:0] cos2;  // mul7: UQ1.24
  wire signed [25:0] cos_inv;  // inv8: SQ1.24
  wire signed [22:0] cos2_minus_cos;  // add9: SQ-2.24
  wire [21:0] a;  // rom6: UQ10.12
  wire signed [44:0] a_times_diff;  // mul10: SQ8.36
  wire signed [44:0] parabola;  // add11: SQ8.36
  wire [12:0] brdf;  // quant11: UQ1.12, codes 0..4096

  blysk_quadratic_rom_q12_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_quadratic_rom_q12_reg_trailing_uq1_12 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_quadratic_rom_q12_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_quadratic_rom_q12_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_quadratic_rom_q12_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_quadratic_rom_q12_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_quadratic_rom_q12_constant_uq1_0 #(.RAW(1'd1)) carry28 (.y_o(carry28_in));  // 1
  blysk_quadratic_rom_q12_constant_uq1_0 #(.RAW(1'd0)) carry30 (.y_o(carry30_in));  // 0
  blysk_quadratic_rom_q12_mul_uq1_12_uq1_12_to_uq1_24 mul7 (.a_i(cos_delta), .b_i(cos_delta), .p_o(cos2));
  blysk_quadratic_rom_q12_inverter_bank_uq1_12_to_sq1_24 inv8 (.a_i(cos_delta), .y_o(cos_inv));
  blysk_quadratic_rom_q12_add_uq1_24_sq1_24_to_sqm2_24 add9 (
      .a_i(cos2), .b_i(cos_inv), .carry_i(carry28_in), .s_o(cos2_minus_cos)
  );
  blysk_quadratic_rom_q12_rom_uq10_0_to_uq10_12 rom6 (.a_i(n), .y_o(a));
  blysk_quadratic_rom_q12_mul_uq10_12_sqm2_24_to_sq8_36 mul10 (
      .a_i(a), .b_i(cos2_minus_cos), .p_o(a_times_diff)
  );
  blysk_quadratic_rom_q12_add_sq8_36_uq1_12_to_sq8_36 add11 (
      .a_i(a_times_diff), .b_i(cos_delta), .carry_i(carry30_in), .s_o(parabola)
  );
  blysk_quadratic_rom_q12_quantise_sq8_36_to_uq1_12_clamp quant11 (.a_i(parabola), .y_o(brdf));
  blysk_quadratic_rom_q12_mul_uq1_12_uq8_0_to_uq8_12 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_quadratic_rom_q12_mul_uq1_12_uq8_0_to_uq8_12 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_quadratic_rom_q12_mul_uq1_12_uq8_0_to_uq8_12 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
