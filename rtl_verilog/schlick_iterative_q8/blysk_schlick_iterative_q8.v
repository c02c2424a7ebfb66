// SPDX-License-Identifier: Apache-2.0
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = c / (n - n c + c), c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:fb18a8a2db9c4981321b90f09a485edaadbafc85f6d7b659b52d32b459f69bb5
//   error against c^n, every code of the cosine: at most 0.205123 (n = 658, c = 0.99609375), bias 0.0130219; 257000 inputs, n in 1..1000, exhaustive
//   error against c^n, pixels of a lit sphere, 512 x 512: at most 0.857831 (n = 1000, c = 0.9980511597743293), bias 0.0244154; 146779000 inputs, n in 1..1000, exhaustive
//   certificate: that of schlick, whose BRDF it computes: BRDF within 0.00195314 of what it computes in real numbers, proved by Gappa 1.4.1; at most 0.001953125 seen, 257000 inputs, exhaustive
//   iCE40: 912 LUT, 101 carry, 97 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 187 LUT, 56 carry, 97 FF, 4 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 44.64 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 3008.7 NAND2, 2688 cells, longest path 6.659 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: settling
`default_nettype none

module blysk_schlick_iterative_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // 16: n, UQ10.0, codes 1..1000
    input  wire [8:0] cos_i,  // 18: cos(delta), 0..1, UQ1.8, codes 0..256
    input  wire [7:0] r_i,  // 19: R k_s, UQ8.0
    input  wire [7:0] g_i,  // 21: G k_s, UQ8.0
    input  wire [7:0] b_i,  // 23: B k_s, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire [15:0] r_o,  // 25: red, UQ8.8
    output wire [15:0] g_o,  // 26: green, UQ8.8
    output wire [15:0] b_o,  // 27: blue, UQ8.8
    output wire valid_o  // a result is at the outputs
);

  wire take;
  wire first;
  wire step;
  wire [9:0] n;  // rg1: UQ10.0, codes 1..1000
  wire [8:0] cos_delta;  // rg2: UQ1.8, codes 0..256
  wire [7:0] r_ks;  // rg3: UQ8.0
  wire [7:0] g_ks;  // rg4: UQ8.0
  wire [7:0] b_ks;  // rg5: UQ8.0
  wire [9:0] quotient;  // div: UQ1.9, codes 0..512
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire signed [9:0] inverted;  // inv_cos: SQ1.8
  wire [8:0] versine;  // add_cos: UQ1.8, codes 0..256
  wire [17:0] drop;  // mul_n: UQ10.8
  wire [17:0] divisor;  // add_divisor: UQ10.8
  wire [8:0] brdf;  // quant: UQ1.8, codes 0..256

  blysk_schlick_iterative_q8_digit_control_10 control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .take_o(take), .first_o(first), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );
  blysk_schlick_iterative_q8_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_schlick_iterative_q8_reg_level_uq1_8 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_schlick_iterative_q8_reg_level_uq8_0 rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks));
  blysk_schlick_iterative_q8_reg_level_uq8_0 rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks));
  blysk_schlick_iterative_q8_reg_level_uq8_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks));
  blysk_schlick_iterative_q8_divide_steps_uq1_8_uq10_8_to_uq1_9 div (
      .clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step), .a_i(cos_delta), .b_i(divisor), .q_o(quotient)
  );
  blysk_schlick_iterative_q8_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_schlick_iterative_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_schlick_iterative_q8_inverter_bank_uq1_8_to_sq1_8 inv_cos (.a_i(cos_delta), .y_o(inverted));
  blysk_schlick_iterative_q8_add_uq1_0_sq1_8_to_uq1_8 add_cos (
      .a_i(unity), .b_i(inverted), .carry_i(unity), .s_o(versine)
  );
  blysk_schlick_iterative_q8_mul_uq10_0_uq1_8_to_uq10_8 mul_n (.a_i(n), .b_i(versine), .p_o(drop));
  blysk_schlick_iterative_q8_add_uq10_8_uq1_8_to_uq10_8 add_divisor (
      .a_i(drop), .b_i(cos_delta), .carry_i(grounded), .s_o(divisor)
  );
  blysk_schlick_iterative_q8_quantise_uq1_9_to_uq1_8 quant (.a_i(quotient), .y_o(brdf));
  blysk_schlick_iterative_q8_mul_uq1_8_uq8_0_to_uq8_8 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_schlick_iterative_q8_mul_uq1_8_uq8_0_to_uq8_8 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_schlick_iterative_q8_mul_uq1_8_uq8_0_to_uq8_8 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));

endmodule

`default_nettype wire
