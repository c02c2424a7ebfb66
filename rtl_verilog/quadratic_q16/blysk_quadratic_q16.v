// SPDX-License-Identifier: Apache-2.0
// device quadratic, format q16, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, a (c^2 - c) + c), a = 2 (1 - e^(-1/2)) n - 1/2, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:c0158a1697a76c345578f9c94e01029c35ee23c39b252cf60d2d38b7dba8a6dd
//   error against c^n, every code of the cosine: at most 0.280155 (n = 969, c = 0.998687744140625), bias -0.00186833; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.281937 (n = 926, c = 0.9986336845598192), bias -0.00363547; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: BRDF within 1.26083e-05 of what it computes in real numbers, proved by Gappa 1.4.1; at most 1.188913569476202e-05 seen, 65537000 inputs, exhaustive
//   iCE40: 3625 LUT, 179 carry, 52 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 215 LUT, 159 carry, 52 FF, 9 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 18.91 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 10247 NAND2, 10074 cells, longest path 18.932 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   settles: within 19.677 ns in OSU018 with its blocks apart, 19.677 ns seen in 20000 pairs of writes; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
`default_nettype none

module blysk_quadratic_q16 (
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
  wire carry28_in;  // carry28: UQ1.0
  wire carry30_in;  // carry30: UQ1.0
  wire [28:0] cos2;  // mul7: UQ1.28
  wire signed [29:0] cos_inv;  // inv8: SQ1.28
  wire signed [26:0] cos2_minus_cos;  // add9: SQ-2.28
  wire [15:0] slope;  // node31: UQ0.16
  wire signed [1:0] offset;  // node32: SQ0.1
  wire [25:0] slope_n;  // mul6: UQ10.16
  wire [25:0] a;  // add15: UQ10.16
  wire signed [52:0] a_times_diff;  // mul10: SQ8.44
  wire signed [52:0] parabola;  // add11: SQ8.44
  wire [16:0] brdf;  // quant11: UQ1.16, codes 0..65536

  blysk_quadratic_q16_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_quadratic_q16_reg_trailing_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_quadratic_q16_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_quadratic_q16_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_quadratic_q16_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_quadratic_q16_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_quadratic_q16_constant_uq1_0 #(.RAW(1'd1)) carry28 (.y_o(carry28_in));  // 1
  blysk_quadratic_q16_constant_uq1_0 #(.RAW(1'd0)) carry30 (.y_o(carry30_in));  // 0
  blysk_quadratic_q16_mul_uq1_16_uq1_16_to_uq1_28 mul7 (.a_i(cos_delta), .b_i(cos_delta), .p_o(cos2));
  blysk_quadratic_q16_inverter_bank_uq1_16_to_sq1_28 inv8 (.a_i(cos_delta), .y_o(cos_inv));
  blysk_quadratic_q16_add_uq1_28_sq1_28_to_sqm2_28 add9 (
      .a_i(cos2), .b_i(cos_inv), .carry_i(carry28_in), .s_o(cos2_minus_cos)
  );
  blysk_quadratic_q16_constant_uq0_16 #(.RAW(16'd51573)) node31 (.y_o(slope));  // 0.786942
  blysk_quadratic_q16_constant_sq0_1 #(.RAW(2'd3)) node32 (.y_o(offset));  // -0.5
  blysk_quadratic_q16_mul_uq10_0_uq0_16_to_uq10_16 mul6 (.a_i(n), .b_i(slope), .p_o(slope_n));
  blysk_quadratic_q16_add_uq10_16_sq0_1_to_uq10_16 add15 (
      .a_i(slope_n), .b_i(offset), .carry_i(carry30_in), .s_o(a)
  );
  blysk_quadratic_q16_mul_uq10_16_sqm2_28_to_sq8_44 mul10 (.a_i(a), .b_i(cos2_minus_cos), .p_o(a_times_diff));
  blysk_quadratic_q16_add_sq8_44_uq1_16_to_sq8_44 add11 (
      .a_i(a_times_diff), .b_i(cos_delta), .carry_i(carry30_in), .s_o(parabola)
  );
  blysk_quadratic_q16_quantise_sq8_44_to_uq1_16_clamp quant11 (.a_i(parabola), .y_o(brdf));
  blysk_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_quadratic_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
