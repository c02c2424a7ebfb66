// SPDX-License-Identifier: Apache-2.0
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c^2 / (c^2 + n (1 - c^2)/2), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:4b75a0e5c72f29f8bfedd36e31482ae7eeaad5fcea010119003af4637b41ea95
//   certificate: that of gx, whose BRDF it computes: BRDF within 3.34406e-08 of what it computes in real numbers, proved by Gappa 1.4.1; at most 3.324063935217225e-08 seen, 65536000 inputs, sampled
//   not known with these options: errors, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_gx_iterative_q24 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [24:0] cos_i,  // 18: cos(delta), 0..1, UQ1.24, codes 0..16777216
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire [31:0] r_o,  // 25: red, UQ8.24
    output wire [31:0] g_o,  // 26: green, UQ8.24
    output wire [31:0] b_o,  // 27: blue, UQ8.24
    output wire valid_o  // a result is at the outputs
);

  wire take;
  wire first;
  wire step;
  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [24:0] cos_delta;  // rg2: UQ1.24, codes 0..16777216
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [25:0] quotient;  // div: UQ1.25, codes 0..33554432
  wire grounded;  // ground: UQ1.0
  wire [36:0] square;  // mul_cos: UQ1.36, codes 0..68719476736
  wire [36:0] rest;  // sub_square: UQ1.36, codes 0..68719476736
  wire [9:0] half_n;  // halve_n: UQ9.1
  wire [45:0] drop;  // mul_n: UQ9.37
  wire [45:0] divisor;  // add_divisor: UQ9.37
  wire [24:0] brdf;  // quant: UQ1.24, codes 0..16777216

  blysk_gx_iterative_q24_digit_control_26 control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .take_o(take), .first_o(first), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );
  blysk_gx_iterative_q24_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_gx_iterative_q24_reg_level_uq1_24 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_gx_iterative_q24_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks));
  blysk_gx_iterative_q24_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks));
  blysk_gx_iterative_q24_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks));
  blysk_gx_iterative_q24_divide_steps_uq1_36_uq9_37_to_uq1_25 div (
      .clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step), .a_i(square), .b_i(divisor), .q_o(quotient)
  );
  blysk_gx_iterative_q24_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_gx_iterative_q24_mul_uq1_24_uq1_24_to_uq1_36 mul_cos (.a_i(cos_delta), .b_i(cos_delta), .p_o(square));
  blysk_gx_iterative_q24_one_minus_uq1_36 sub_square (.a_i(square), .y_o(rest));
  blysk_gx_iterative_q24_move_point_uq10_0_to_uq9_1 halve_n (.a_i(n), .y_o(half_n));
  blysk_gx_iterative_q24_mul_uq9_1_uq1_36_to_uq9_37 mul_n (.a_i(half_n), .b_i(rest), .p_o(drop));
  blysk_gx_iterative_q24_add_uq9_37_uq1_36_to_uq9_37 add_divisor (
      .a_i(drop), .b_i(square), .carry_i(grounded), .s_o(divisor)
  );
  blysk_gx_iterative_q24_quantise_uq1_25_to_uq1_24 quant (.a_i(quotient), .y_o(brdf));
  blysk_gx_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_gx_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_gx_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
