// SPDX-License-Identifier: Apache-2.0
// device rational, format q16, coefficients from two memories of 1000 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, 1 - r u)/(1 + d u), u = 1 - c, r and d for each n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:2c022f9acc08a081ba8a6a986dbbf31db06eea9ec23337006905a67ef042a923
//   error against c^n, every code of the cosine: at most 0.0248061 (n = 903, c = 0.9996795654296875), bias -5.60784e-05; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.0296898 (n = 914, c = 0.9996566159572426), bias -0.000103714; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 1.01793e-05 of what it computes in real numbers, proved by Gappa 1.4.1; at most 9.36057380918065e-06 seen, 65537000 inputs, exhaustive
//   iCE40: 4808 LUT, 912 carry, 52 FF, 0 DSP, 57344 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 1848 LUT, 966 carry, 52 FF, 7 DSP, 57344 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 5.78 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 18623.8 NAND2, 17882 cells, longest path 58.057 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_rational_q16 (
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
  wire [25:0] fall;  // rom_fall: UQ9.17
  wire [27:0] drop;  // mul_fall: UQ9.19
  wire signed [28:0] drop_inverted;  // inv_drop: SQ9.19
  wire signed [28:0] line;  // add_line: SQ9.19
  wire [19:0] dividend;  // quant_line: UQ1.19, codes 0..524288
  wire [26:0] rise;  // rom_rise: UQ10.17
  wire [28:0] climb;  // mul_rise: UQ10.19
  wire [28:0] sum;  // add_sum: UQ10.19
  wire [21:0] divisor;  // quant_sum: UQ3.19
  wire [17:0] quotient;  // div: UQ1.17, codes 0..131072
  wire [16:0] brdf;  // quant: UQ1.16, codes 0..65536

  blysk_rational_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_rational_q16_reg_trailing_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_rational_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_rational_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_rational_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_rational_q16_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_rational_q16_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_rational_q16_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_rational_q16_one_minus_uq1_16 sub_cos (.a_i(cos_delta), .y_o(versine));
  blysk_rational_q16_rom_uq10_0_to_uq9_17 rom_fall (.a_i(n), .y_o(fall));
  blysk_rational_q16_mul_uq9_17_uq1_16_to_uq9_19 mul_fall (.a_i(fall), .b_i(versine), .p_o(drop));
  blysk_rational_q16_inverter_bank_uq9_19_to_sq9_19 inv_drop (.a_i(drop), .y_o(drop_inverted));
  blysk_rational_q16_add_uq1_0_sq9_19_to_sq9_19 add_line (
      .a_i(unity), .b_i(drop_inverted), .carry_i(unity), .s_o(line)
  );
  blysk_rational_q16_quantise_sq9_19_to_uq1_19_clamp quant_line (.a_i(line), .y_o(dividend));
  blysk_rational_q16_rom_uq10_0_to_uq10_17 rom_rise (.a_i(n), .y_o(rise));
  blysk_rational_q16_mul_uq10_17_uq1_16_to_uq10_19 mul_rise (.a_i(rise), .b_i(versine), .p_o(climb));
  blysk_rational_q16_add_uq1_0_uq10_19_to_uq10_19 add_sum (
      .a_i(unity), .b_i(climb), .carry_i(grounded), .s_o(sum)
  );
  blysk_rational_q16_quantise_uq10_19_to_uq3_19_clamp quant_sum (.a_i(sum), .y_o(divisor));
  blysk_rational_q16_divide_uq1_19_uq3_19_to_uq1_17 div (.a_i(dividend), .b_i(divisor), .q_o(quotient));
  blysk_rational_q16_quantise_uq1_17_to_uq1_16 quant (.a_i(quotient), .y_o(brdf));
  blysk_rational_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_rational_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_rational_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
