// SPDX-License-Identifier: Apache-2.0
// device rational, format q12, coefficients from two memories of 1000 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, 1 - r u)/(1 + d u), u = 1 - c, r and d for each n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:4c55b37f59bdbcd33ab9a0560b31751ad9ac43de96936fa7edd0e7464a2d3b52
//   error against c^n, every code of the cosine: at most 0.0249206 (n = 148, c = 0.988037109375), bias -5.55317e-05; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.11739 (n = 1000, c = 0.9998681020194962), bias -9.7772e-05; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.00016287 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0001475735523979449 seen, 4097000 inputs, exhaustive
//   iCE40: 3205 LUT, 600 carry, 48 FF, 0 DSP, 49152 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 1056 LUT, 551 carry, 48 FF, 7 DSP, 49152 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 7.46 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 13078.2 NAND2, 12559 cells, longest path 41.564 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 48.106 ns in OSU018 with its blocks apart, 47.999 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_rational_q12 (
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
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [12:0] versine;  // sub_cos: UQ1.12, codes 0..4096
  wire [21:0] fall;  // rom_fall: UQ9.13
  wire [23:0] drop;  // mul_fall: UQ9.15
  wire signed [24:0] drop_inverted;  // inv_drop: SQ9.15
  wire signed [24:0] line;  // add_line: SQ9.15
  wire [15:0] dividend;  // quant_line: UQ1.15, codes 0..32768
  wire [22:0] rise;  // rom_rise: UQ10.13
  wire [24:0] climb;  // mul_rise: UQ10.15
  wire [24:0] sum;  // add_sum: UQ10.15
  wire [17:0] divisor;  // quant_sum: UQ3.15
  wire [13:0] quotient;  // div: UQ1.13, codes 0..8192
  wire [12:0] brdf;  // quant: UQ1.12, codes 0..4096

  blysk_rational_q12_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_rational_q12_reg_trailing_uq1_12 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_rational_q12_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_rational_q12_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_rational_q12_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_rational_q12_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_rational_q12_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_rational_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_rational_q12_one_minus_uq1_12 sub_cos (.a_i(cos_delta), .y_o(versine));
  blysk_rational_q12_rom_uq10_0_to_uq9_13 rom_fall (.a_i(n), .y_o(fall));
  blysk_rational_q12_mul_uq9_13_uq1_12_to_uq9_15 mul_fall (.a_i(fall), .b_i(versine), .p_o(drop));
  blysk_rational_q12_inverter_bank_uq9_15_to_sq9_15 inv_drop (.a_i(drop), .y_o(drop_inverted));
  blysk_rational_q12_add_uq1_0_sq9_15_to_sq9_15 add_line (
      .a_i(unity), .b_i(drop_inverted), .carry_i(unity), .s_o(line)
  );
  blysk_rational_q12_quantise_sq9_15_to_uq1_15_clamp quant_line (.a_i(line), .y_o(dividend));
  blysk_rational_q12_rom_uq10_0_to_uq10_13 rom_rise (.a_i(n), .y_o(rise));
  blysk_rational_q12_mul_uq10_13_uq1_12_to_uq10_15 mul_rise (.a_i(rise), .b_i(versine), .p_o(climb));
  blysk_rational_q12_add_uq1_0_uq10_15_to_uq10_15 add_sum (
      .a_i(unity), .b_i(climb), .carry_i(grounded), .s_o(sum)
  );
  blysk_rational_q12_quantise_uq10_15_to_uq3_15_clamp quant_sum (.a_i(sum), .y_o(divisor));
  blysk_rational_q12_divide_uq1_15_uq3_15_to_uq1_13 div (.a_i(dividend), .b_i(divisor), .q_o(quotient));
  blysk_rational_q12_quantise_uq1_13_to_uq1_12 quant (.a_i(quotient), .y_o(brdf));
  blysk_rational_q12_mul_uq1_12_uq8_0_to_uq8_12 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_rational_q12_mul_uq1_12_uq8_0_to_uq8_12 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_rational_q12_mul_uq1_12_uq8_0_to_uq8_12 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
