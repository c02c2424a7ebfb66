// SPDX-License-Identifier: Apache-2.0
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, a (c^2 - c) + c), a = 2 (1 - e^(-1/2)) n - 1/2, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:de0a1d0b5ed72f60ea7a2bad58d8c1ab7f995ebcdc898b02a9a56f24ef04fa76
//   error against c^n, every code of the cosine: at most 0.280155 (n = 969, c = 0.998687744140625), bias -0.00186833; 65537000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.281937 (n = 926, c = 0.9986336845598192), bias -0.00363547; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: that of quadratic, whose BRDF it computes: BRDF within 1.26083e-05 of what it computes in real numbers, proved by Gappa 1.4.1; at most 1.188913569476202e-05 seen, 65537000 inputs, exhaustive
//   iCE40: 3670 LUT, 215 carry, 352 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 224 LUT, 168 carry, 352 FF, 9 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 50.66 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 12562.4 NAND2, 11464 cells, longest path 7.335 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_quadratic_pipelined_q16 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [16:0] cos_i,  // 18: cos(delta), 0..1, UQ1.16, codes 0..65536
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    input  wire stall_i,  // keeps a result at the outputs
    output wire ready_o,  // start_i takes the inputs
    output wire [23:0] r_o,  // 25: red, UQ8.16
    output wire [23:0] g_o,  // 26: green, UQ8.16
    output wire [23:0] b_o,  // 27: blue, UQ8.16
    output wire valid_o  // a result is at the outputs
);

  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [16:0] cos_delta;  // rg2: UQ1.16, codes 0..65536
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [7:0] r_last;  // pipe_r: UQ8.0
  wire [7:0] g_last;  // pipe_g: UQ8.0
  wire [7:0] b_last;  // pipe_b: UQ8.0
  wire [16:0] brdf;  // pipe_brdf: UQ1.16, codes 0..65536
  wire [16:0] cos_1;  // pipe_cos: UQ1.16, codes 0..65536
  wire [16:0] cos_3;  // pipe_cos_late: UQ1.16, codes 0..65536
  wire [28:0] cos2_1;  // pipe_cos2: UQ1.28
  wire [25:0] a_2;  // pipe_a: UQ10.16
  wire signed [26:0] diff_2;  // pipe_diff: SQ-2.28
  wire signed [52:0] a_diff_3;  // pipe_a_diff: SQ8.44
  wire [25:0] slope_n_1;  // pipe_slope_n: UQ10.16
  wire go;
  wire take;
  wire carry28_in;  // carry28: UQ1.0
  wire carry30_in;  // carry30: UQ1.0
  wire [28:0] cos2;  // mul7: UQ1.28
  wire signed [29:0] cos_inv;  // inv8: SQ1.28
  wire signed [26:0] cos2_minus_cos;  // add9: SQ-2.28
  wire signed [52:0] a_times_diff;  // mul10: SQ8.44
  wire signed [52:0] parabola;  // add11: SQ8.44
  wire [16:0] brdf_first;  // quant11: UQ1.16, codes 0..65536
  wire [15:0] slope;  // node31: UQ0.16
  wire signed [1:0] offset;  // node32: SQ0.1
  wire [25:0] slope_n;  // mul6: UQ10.16
  wire [25:0] a;  // add15: UQ10.16

  blysk_quadratic_pipelined_q16_pipe_5 pipe_valid (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o)
  );
  blysk_quadratic_pipelined_q16_reg_level_uq10_0 rg1 (
      .clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n)
  );
  blysk_quadratic_pipelined_q16_reg_level_uq1_16 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_quadratic_pipelined_q16_reg_level_uq8_0 rg3 (
      .clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks)
  );
  blysk_quadratic_pipelined_q16_reg_level_uq8_0 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks)
  );
  blysk_quadratic_pipelined_q16_reg_level_uq8_0 rg5 (
      .clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks)
  );
  blysk_quadratic_pipelined_q16_pipe_uq8_0_4 pipe_r (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(r_ks), .q_o(r_last)
  );
  blysk_quadratic_pipelined_q16_pipe_uq8_0_4 pipe_g (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(g_ks), .q_o(g_last)
  );
  blysk_quadratic_pipelined_q16_pipe_uq8_0_4 pipe_b (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(b_ks), .q_o(b_last)
  );
  blysk_quadratic_pipelined_q16_pipe_uq1_16_1 pipe_brdf (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(brdf_first), .q_o(brdf)
  );
  blysk_quadratic_pipelined_q16_pipe_uq1_16_1 pipe_cos (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(cos_delta), .q_o(cos_1)
  );
  blysk_quadratic_pipelined_q16_pipe_uq1_16_2 pipe_cos_late (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(cos_1), .q_o(cos_3)
  );
  blysk_quadratic_pipelined_q16_pipe_uq1_28_1 pipe_cos2 (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(cos2), .q_o(cos2_1)
  );
  blysk_quadratic_pipelined_q16_pipe_uq10_16_1 pipe_a (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(a), .q_o(a_2));
  blysk_quadratic_pipelined_q16_pipe_sqm2_28_1 pipe_diff (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(cos2_minus_cos), .q_o(diff_2)
  );
  blysk_quadratic_pipelined_q16_pipe_sq8_44_1 pipe_a_diff (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(a_times_diff), .q_o(a_diff_3)
  );
  blysk_quadratic_pipelined_q16_pipe_uq10_16_1 pipe_slope_n (
      .clk(clk), .rst_n(rst_n), .go_i(go), .d_i(slope_n), .q_o(slope_n_1)
  );
  blysk_quadratic_pipelined_q16_pipe_control control (
      .start_i(start_i), .stall_i(stall_i), .valid_i(valid_o), .go_o(go), .take_o(take), .ready_o(ready_o)
  );
  blysk_quadratic_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul12 (.a_i(brdf), .b_i(r_last), .p_o(r_o));
  blysk_quadratic_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul13 (.a_i(brdf), .b_i(g_last), .p_o(g_o));
  blysk_quadratic_pipelined_q16_mul_uq1_16_uq8_0_to_uq8_16 mul14 (.a_i(brdf), .b_i(b_last), .p_o(b_o));
  blysk_quadratic_pipelined_q16_constant_uq1_0 #(.RAW(1'd1)) carry28 (.y_o(carry28_in));  // 1
  blysk_quadratic_pipelined_q16_constant_uq1_0 #(.RAW(1'd0)) carry30 (.y_o(carry30_in));  // 0
  blysk_quadratic_pipelined_q16_mul_uq1_16_uq1_16_to_uq1_28 mul7 (.a_i(cos_delta), .b_i(cos_delta), .p_o(cos2));
  blysk_quadratic_pipelined_q16_inverter_bank_uq1_16_to_sq1_28 inv8 (.a_i(cos_1), .y_o(cos_inv));
  blysk_quadratic_pipelined_q16_add_uq1_28_sq1_28_to_sqm2_28 add9 (
      .a_i(cos2_1), .b_i(cos_inv), .carry_i(carry28_in), .s_o(cos2_minus_cos)
  );
  blysk_quadratic_pipelined_q16_mul_uq10_16_sqm2_28_to_sq8_44 mul10 (
      .a_i(a_2), .b_i(diff_2), .p_o(a_times_diff)
  );
  blysk_quadratic_pipelined_q16_add_sq8_44_uq1_16_to_sq8_44 add11 (
      .a_i(a_diff_3), .b_i(cos_3), .carry_i(carry30_in), .s_o(parabola)
  );
  blysk_quadratic_pipelined_q16_quantise_sq8_44_to_uq1_16_clamp quant11 (.a_i(parabola), .y_o(brdf_first));
  blysk_quadratic_pipelined_q16_constant_uq0_16 #(.RAW(16'd51573)) node31 (.y_o(slope));  // 0.786942
  blysk_quadratic_pipelined_q16_constant_sq0_1 #(.RAW(2'd3)) node32 (.y_o(offset));  // -0.5
  blysk_quadratic_pipelined_q16_mul_uq10_0_uq0_16_to_uq10_16 mul6 (.a_i(n), .b_i(slope), .p_o(slope_n));
  blysk_quadratic_pipelined_q16_add_uq10_16_sq0_1_to_uq10_16 add15 (
      .a_i(slope_n_1), .b_i(offset), .carry_i(carry30_in), .s_o(a)
  );

endmodule

`default_nettype wire
