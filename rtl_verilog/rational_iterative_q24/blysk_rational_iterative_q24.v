// SPDX-License-Identifier: Apache-2.0
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: BRDF = max(0, 1 - r u)/(1 + d u), u = 1 - c, r and d for each n, c = cos(delta); red, green, blue = BRDF (R, G, B) k_s
//   digest: sha256:2dab975523d5b284eacd45a8496be0d83a647914717a15289c7e20dae6380478
//   certificate: that of rational, whose BRDF it computes: BRDF within 3.97629e-08 of what it computes in real numbers, proved by Gappa 1.4.1; at most 3.736584739294805e-08 seen, 65536000 inputs, sampled
//   not known with these options: errors, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_rational_iterative_q24 (
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
  wire unity;  // node1: UQ1.0
  wire grounded;  // ground: UQ1.0
  wire [24:0] versine;  // sub_cos: UQ1.24, codes 0..16777216
  wire [24:0] brdf;  // quant: UQ1.24, codes 0..16777216
  wire [33:0] fall;  // rom_fall: UQ9.25
  wire [35:0] drop;  // mul_fall: UQ9.27
  wire signed [36:0] drop_inverted;  // inv_drop: SQ9.27
  wire signed [36:0] line;  // add_line: SQ9.27
  wire [27:0] dividend;  // quant_line: UQ1.27, codes 0..134217728
  wire [34:0] rise;  // rom_rise: UQ10.25
  wire [36:0] climb;  // mul_rise: UQ10.27
  wire [36:0] sum;  // add_sum: UQ10.27
  wire [29:0] divisor;  // quant_sum: UQ3.27

  blysk_rational_iterative_q24_digit_control_26 control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .take_o(take), .first_o(first), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );
  blysk_rational_iterative_q24_reg_level_uq10_0 rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  blysk_rational_iterative_q24_reg_level_uq1_24 rg2 (
      .clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(cos_delta)
  );
  blysk_rational_iterative_q24_reg_level_uq8_0 rg3 (
      .clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r_ks)
  );
  blysk_rational_iterative_q24_reg_level_uq8_0 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g_ks)
  );
  blysk_rational_iterative_q24_reg_level_uq8_0 rg5 (
      .clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b_ks)
  );
  blysk_rational_iterative_q24_divide_steps_uq1_27_uq3_27_to_uq1_25 div (
      .clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step), .a_i(dividend), .b_i(divisor), .q_o(quotient)
  );
  blysk_rational_iterative_q24_constant_uq1_0 #(.RAW(1'd1)) node1 (.y_o(unity));  // 1
  blysk_rational_iterative_q24_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(grounded));  // 0
  blysk_rational_iterative_q24_one_minus_uq1_24 sub_cos (.a_i(cos_delta), .y_o(versine));
  blysk_rational_iterative_q24_quantise_uq1_25_to_uq1_24 quant (.a_i(quotient), .y_o(brdf));
  blysk_rational_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul12 (.a_i(brdf), .b_i(r_ks), .p_o(r_o));
  blysk_rational_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul13 (.a_i(brdf), .b_i(g_ks), .p_o(g_o));
  blysk_rational_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 mul14 (.a_i(brdf), .b_i(b_ks), .p_o(b_o));
  blysk_rational_iterative_q24_rom_uq10_0_to_uq9_25 rom_fall (.a_i(n), .y_o(fall));
  blysk_rational_iterative_q24_mul_uq9_25_uq1_24_to_uq9_27 mul_fall (.a_i(fall), .b_i(versine), .p_o(drop));
  blysk_rational_iterative_q24_inverter_bank_uq9_27_to_sq9_27 inv_drop (.a_i(drop), .y_o(drop_inverted));
  blysk_rational_iterative_q24_add_uq1_0_sq9_27_to_sq9_27 add_line (
      .a_i(unity), .b_i(drop_inverted), .carry_i(unity), .s_o(line)
  );
  blysk_rational_iterative_q24_quantise_sq9_27_to_uq1_27_clamp quant_line (.a_i(line), .y_o(dividend));
  blysk_rational_iterative_q24_rom_uq10_0_to_uq10_25 rom_rise (.a_i(n), .y_o(rise));
  blysk_rational_iterative_q24_mul_uq10_25_uq1_24_to_uq10_27 mul_rise (.a_i(rise), .b_i(versine), .p_o(climb));
  blysk_rational_iterative_q24_add_uq1_0_uq10_27_to_uq10_27 add_sum (
      .a_i(unity), .b_i(climb), .carry_i(grounded), .s_o(sum)
  );
  blysk_rational_iterative_q24_quantise_uq10_27_to_uq3_27_clamp quant_sum (.a_i(sum), .y_o(divisor));

endmodule

`default_nettype wire
