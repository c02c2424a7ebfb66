// SPDX-License-Identifier: Apache-2.0
// device lyon, format q16, degree 4, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, 1 - n (1 - c)/4)^4, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:8528aa428bdae4167dbb8887e67f4a42fc5597587af11391a50f9cec0508f7cb
//   error against c^n, every code of the cosine: at most 0.316406 (n = 1, c = 0), bias -0.000700685; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.305755 (n = 1, c = 0.018539761437612663), bias -0.00168157; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 9.53684e-06 of what it computes in real numbers, proved by Gappa 1.4.1; at most 9.495720561969456e-06 seen, 65537000 inputs, exhaustive
//   iCE40: 2937 LUT, 173 carry, 52 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 255 LUT, 162 carry, 52 FF, 10 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 15.31 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 8328.4 NAND2, 8150 cells, longest path 23.181 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_lyon_q16 (
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
  wire signed [17:0] inverted;  // inv_cos: SQ1.16
  wire [16:0] versine;  // add_cos: UQ1.16, codes 0..65536
  wire [9:0] part;  // part_n: UQ8.2
  wire [25:0] drop;  // mul_n: UQ8.18
  wire signed [26:0] drop_inverted;  // inv_drop: SQ8.18
  wire signed [26:0] line;  // add_line: SQ8.18
  wire [18:0] root;  // quant_line: UQ1.18, codes 0..262144
  wire [19:0] power2;  // square2: UQ1.19, codes 0..524288
  wire [16:0] brdf;  // square4: UQ1.16, codes 0..65536

  blysk_lyon_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_lyon_q16_reg_trailing_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_lyon_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_lyon_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_lyon_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_lyon_q16_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_lyon_q16_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_lyon_q16_inverter_bank_uq1_16_to_sq1_16 inv_cos (.a_i(cos_delta), .y_o(inverted));
  blysk_lyon_q16_add_uq1_0_sq1_16_to_uq1_16 add_cos (
      .a_i(unity), .b_i(inverted), .carry_i(unity), .s_o(versine)
  );
  blysk_lyon_q16_move_point_uq10_0_to_uq8_2 part_n (.a_i(n), .y_o(part));
  blysk_lyon_q16_mul_uq8_2_uq1_16_to_uq8_18 mul_n (.a_i(part), .b_i(versine), .p_o(drop));
  blysk_lyon_q16_inverter_bank_uq8_18_to_sq8_18 inv_drop (.a_i(drop), .y_o(drop_inverted));
  blysk_lyon_q16_add_uq1_0_sq8_18_to_sq8_18 add_line (
      .a_i(unity), .b_i(drop_inverted), .carry_i(unity), .s_o(line)
  );
  blysk_lyon_q16_quantise_sq8_18_to_uq1_18_clamp quant_line (.a_i(line), .y_o(root));
  blysk_lyon_q16_mul_uq1_18_uq1_18_to_uq1_19 square2 (.a_i(root), .b_i(root), .p_o(power2));
  blysk_lyon_q16_mul_uq1_19_uq1_19_to_uq1_16 square4 (.a_i(power2), .b_i(power2), .p_o(brdf));
  blysk_lyon_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_lyon_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_lyon_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
