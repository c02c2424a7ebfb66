// SPDX-License-Identifier: Apache-2.0
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c / (n - n c + c), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:725f943f1a5a05f52e85c9c9beff5b6ccec0f2c079707e4cfcde5df525fda23a
//   error against c^n, every code of the cosine: at most 0.203459 (n = 945, c = 0.997314453125), bias 0.0133564; 4097000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.213901 (n = 995, c = 0.9976842579877792), bias 0.02348; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: that of schlick, whose BRDF it computes: BRDF within 0.000122071 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.0001220703125 seen, 4097000 inputs, exhaustive
//   iCE40: 1290 LUT, 133 carry, 113 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 228 LUT, 72 carry, 113 FF, 4 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 37.27 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 4143.2 NAND2, 3753 cells, longest path 7.266 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_schlick_iterative_q12 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [12:0] cos_i,  // 18: cos(delta), 0..1, UQ1.12, codes 0..4096
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire [19:0] r_o,  // 25: red, UQ8.12
    output wire [19:0] g_o,  // 26: green, UQ8.12
    output wire [19:0] b_o,  // 27: blue, UQ8.12
    output wire valid_o  // a result is at the outputs
);

  wire take;
  wire first;
  wire step;
  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [12:0] cos_delta;  // rg2: UQ1.12, codes 0..4096
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [13:0] quotient;  // div: UQ1.13, codes 0..8192
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire signed [13:0] inverted;  // inv_cos: SQ1.12
  wire [12:0] versine;  // add_cos: UQ1.12, codes 0..4096
  wire [21:0] drop;  // mul_n: UQ10.12
  wire [21:0] divisor;  // add_divisor: UQ10.12
  wire [12:0] brdf;  // quant: UQ1.12, codes 0..4096

  blysk_schlick_iterative_q12_digit_control_14 control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .take_o(take), .first_o(first), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );
  blysk_schlick_iterative_q12_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_schlick_iterative_q12_reg_level_uq1_12 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_schlick_iterative_q12_reg_level_uq8_0 rg3 (
      .clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks)
  );
  blysk_schlick_iterative_q12_reg_level_uq8_0 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks)
  );
  blysk_schlick_iterative_q12_reg_level_uq8_0 rg5 (
      .clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks)
  );
  blysk_schlick_iterative_q12_divide_steps_uq1_12_uq10_12_to_uq1_13 div (
      .clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step), .a_i(cos_delta), .b_i(divisor), .q_o(quotient)
  );
  blysk_schlick_iterative_q12_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_schlick_iterative_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_schlick_iterative_q12_inverter_bank_uq1_12_to_sq1_12 inv_cos (.a_i(cos_delta), .y_o(inverted));
  blysk_schlick_iterative_q12_add_uq1_0_sq1_12_to_uq1_12 add_cos (
      .a_i(unity), .b_i(inverted), .carry_i(unity), .s_o(versine)
  );
  blysk_schlick_iterative_q12_mul_uq10_0_uq1_12_to_uq10_12 mul_n (.a_i(n), .b_i(versine), .p_o(drop));
  blysk_schlick_iterative_q12_add_uq10_12_uq1_12_to_uq10_12 add_divisor (
      .a_i(drop), .b_i(cos_delta), .carry_i(grounded), .s_o(divisor)
  );
  blysk_schlick_iterative_q12_quantise_uq1_13_to_uq1_12 quant (.a_i(quotient), .y_o(brdf));
  blysk_schlick_iterative_q12_mul_uq1_12_uq8_0_to_uq8_12 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_schlick_iterative_q12_mul_uq1_12_uq8_0_to_uq8_12 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_schlick_iterative_q12_mul_uq1_12_uq8_0_to_uq8_12 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
