// SPDX-License-Identifier: Apache-2.0
// device quadratic, format q24, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, a (c^2 - c) + c), a = 2 (1 - e^(-1/2)) n - 1/2, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:5d31ba00514916dd95bc34f7ea778738dd985273ef6e29329881024de1b8ac15
//   certificate: BRDF within 5.84844e-08 of what it computes in real numbers, proved by Gappa 1.4.1; at most 5.7574682866753935e-08 seen, 65536000 inputs, sampled
//   not known with these options: errors, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_quadratic_q24 (
    input  wire clk,  // samples the write strobes
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire n_we_i,  // 15: write rg1
    input  wire [24:0] cos_i,  // 18: cos(delta), 0..1, UQ1.24, codes 0..16777216
    input  wire cos_we_i,  // 17: write rg2, by its trailing edge
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire r_we_i,  // 20: write rg3
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire g_we_i,  // 22: write rg4
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire b_we_i,  // 24: write rg5
    output wire [31:0] r_o,  // 25: red, UQ8.24
    output wire [31:0] g_o,  // 26: green, UQ8.24
    output wire [31:0] b_o,  // 27: blue, UQ8.24
    output wire valid_o  // 29: 25..27 are valid at its leading edge
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [24:0] cos_delta;  // rg2: UQ1.24, codes 0..16777216
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire carry28_in;  // carry28: UQ1.0
  wire carry30_in;  // carry30: UQ1.0
  wire [35:0] cos2;  // mul7: UQ1.35
  wire signed [36:0] cos_inv;  // inv8: SQ1.35
  wire signed [33:0] cos2_minus_cos;  // add9: SQ-2.35
  wire [19:0] slope;  // node31: UQ0.20
  wire signed [1:0] offset;  // node32: SQ0.1
  wire [29:0] slope_n;  // mul6: UQ10.20
  wire [29:0] a;  // add15: UQ10.20
  wire signed [63:0] a_times_diff;  // mul10: SQ8.55
  wire signed [63:0] parabola;  // add11: SQ8.55
  wire [24:0] brdf;  // quant11: UQ1.24, codes 0..16777216

  blysk_quadratic_q24_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  blysk_quadratic_q24_reg_trailing_uq1_24 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(cos_delta)
  );
  blysk_quadratic_q24_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r_ks));
  blysk_quadratic_q24_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g_ks));
  blysk_quadratic_q24_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b_ks));
  blysk_quadratic_q24_buffer buf29 (.a_i(cos_we_i), .y_o(valid_o));
  blysk_quadratic_q24_constant_uq1_0 #(.RAW(1'd1)) carry28 (.y_o(carry28_in));  // 1
  blysk_quadratic_q24_constant_uq1_0 #(.RAW(1'd0)) carry30 (.y_o(carry30_in));  // 0
  blysk_quadratic_q24_mul_uq1_24_uq1_24_to_uq1_35 mul7 (.a_i(cos_delta), .b_i(cos_delta), .p_o(cos2));
  blysk_quadratic_q24_inverter_bank_uq1_24_to_sq1_35 inv8 (.a_i(cos_delta), .y_o(cos_inv));
  blysk_quadratic_q24_add_uq1_35_sq1_35_to_sqm2_35 add9 (
      .a_i(cos2), .b_i(cos_inv), .carry_i(carry28_in), .s_o(cos2_minus_cos)
  );
  blysk_quadratic_q24_constant_uq0_20 #(.RAW(20'd825165)) node31 (.y_o(slope));  // 0.786939
  blysk_quadratic_q24_constant_sq0_1 #(.RAW(2'd3)) node32 (.y_o(offset));  // -0.5
  blysk_quadratic_q24_mul_uq10_0_uq0_20_to_uq10_20 mul6 (.a_i(n), .b_i(slope), .p_o(slope_n));
  blysk_quadratic_q24_add_uq10_20_sq0_1_to_uq10_20 add15 (
      .a_i(slope_n), .b_i(offset), .carry_i(carry30_in), .s_o(a)
  );
  blysk_quadratic_q24_mul_uq10_20_sqm2_35_to_sq8_55 mul10 (.a_i(a), .b_i(cos2_minus_cos), .p_o(a_times_diff));
  blysk_quadratic_q24_add_sq8_55_uq1_24_to_sq8_55 add11 (
      .a_i(a_times_diff), .b_i(cos_delta), .carry_i(carry30_in), .s_o(parabola)
  );
  blysk_quadratic_q24_quantise_sq8_55_to_uq1_24_clamp quant11 (.a_i(parabola), .y_o(brdf));
  blysk_quadratic_q24_mul_uq1_24_uq8_0_to_uq8_24 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_quadratic_q24_mul_uq1_24_uq8_0_to_uq8_24 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_quadratic_q24_mul_uq1_24_uq8_0_to_uq8_24 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
