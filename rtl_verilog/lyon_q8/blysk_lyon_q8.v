// SPDX-License-Identifier: Apache-2.0
// device lyon, format q8, degree 4, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, 1 - n (1 - c)/4)^4, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:8c87f480d60be19bcf73a4360240f0a426c894742e18052e09c826c7927623ff
//   error against c^n, every code of the cosine: at most 0.316406 (n = 1, c = 0), bias -0.000661539; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias -0.000390853; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 0.00244095 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0023163575533544645 seen, 257000 inputs, exhaustive
//   iCE40: 1186 LUT, 98 carry, 44 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 70 LUT, 24 carry, 44 FF, 6 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 19.46 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 3470.9 NAND2, 3321 cells, longest path 16.167 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 17.512 ns in OSU018 with its blocks apart, 17.358 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_lyon_q8 (
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
  wire signed [9:0] inverted;  // inv_cos: SQ1.8
  wire [8:0] versine;  // add_cos: UQ1.8, codes 0..256
  wire [9:0] part;  // part_n: UQ8.2
  wire [17:0] drop;  // mul_n: UQ8.10
  wire signed [18:0] drop_inverted;  // inv_drop: SQ8.10
  wire signed [18:0] line;  // add_line: SQ8.10
  wire [10:0] root;  // quant_line: UQ1.10, codes 0..1024
  wire [11:0] power2;  // square2: UQ1.11, codes 0..2048
  wire [8:0] brdf;  // square4: UQ1.8, codes 0..256

  blysk_lyon_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_lyon_q8_reg_trailing_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_lyon_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_lyon_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_lyon_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_lyon_q8_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_lyon_q8_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_lyon_q8_inverter_bank_uq1_8_to_sq1_8 inv_cos (.a_i(cos_delta), .y_o(inverted));
  blysk_lyon_q8_add_uq1_0_sq1_8_to_uq1_8 add_cos (.a_i(unity), .b_i(inverted), .carry_i(unity), .s_o(versine));
  blysk_lyon_q8_move_point_uq10_0_to_uq8_2 part_n (.a_i(n), .y_o(part));
  blysk_lyon_q8_mul_uq8_2_uq1_8_to_uq8_10 mul_n (.a_i(part), .b_i(versine), .p_o(drop));
  blysk_lyon_q8_inverter_bank_uq8_10_to_sq8_10 inv_drop (.a_i(drop), .y_o(drop_inverted));
  blysk_lyon_q8_add_uq1_0_sq8_10_to_sq8_10 add_line (
      .a_i(unity), .b_i(drop_inverted), .carry_i(unity), .s_o(line)
  );
  blysk_lyon_q8_quantise_sq8_10_to_uq1_10_clamp quant_line (.a_i(line), .y_o(root));
  blysk_lyon_q8_mul_uq1_10_uq1_10_to_uq1_11 square2 (.a_i(root), .b_i(root), .p_o(power2));
  blysk_lyon_q8_mul_uq1_11_uq1_11_to_uq1_8 square4 (.a_i(power2), .b_i(power2), .p_o(brdf));
  blysk_lyon_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_lyon_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_lyon_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
