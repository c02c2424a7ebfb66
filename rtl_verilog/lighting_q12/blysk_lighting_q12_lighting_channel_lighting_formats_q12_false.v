// SPDX-License-Identifier: Apache-2.0
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_lighting_channel_lighting_formats_q12_false (
    input  wire clk,
    input  wire rst_n,
    input  wire take_i,
    input  wire first_i,
    input  wire ground_i,
    input  wire [12:0] nl_i,  // UQ1.12, codes 0..4096
    input  wire [15:0] ambient_i,  // UQ8.8, codes 0..65280
    input  wire [15:0] diffuse_i,  // UQ8.8, codes 0..65280
    input  wire [19:0] specular_i,  // UQ8.12, codes 0..1044480
    output wire [23:0] sum_o,  // UQ8.16, codes 0..16711680
    output wire [7:0] channel_o  // UQ8.0
);

  wire [23:0] ambient_term;  // ambient: UQ8.16, codes 0..16711680
  wire [23:0] diffuse_term;  // diffuse: UQ8.16, codes 0..16711680
  wire [23:0] specular_term;  // specular: UQ8.16, codes 0..16711680
  wire [23:0] sum_before;  // base: UQ8.16, codes 0..16711680
  wire [24:0] lit;  // add_diffuse: UQ9.16
  wire [25:0] sum;  // add_specular: UQ10.16
  wire [23:0] level;  // saturate: UQ8.16, codes 0..16711680

  blysk_lighting_q12_reg_level_uq8_16 accumulator (
      .clk(clk), .rst_n(rst_n), .d_i(level), .we_i(take_i), .q_o(sum_o)
  );
  blysk_lighting_q12_rescale_uq8_8_to_uq8_16 ambient (.a_i(ambient_i), .y_o(ambient_term));
  blysk_lighting_q12_mul_uq8_8_uq1_12_to_uq8_16 diffuse (.a_i(diffuse_i), .b_i(nl_i), .p_o(diffuse_term));
  blysk_lighting_q12_rescale_uq8_12_to_uq8_16 specular (.a_i(specular_i), .y_o(specular_term));
  blysk_lighting_q12_multiplexer_uq8_16_uq8_16_to_uq8_16 base (
      .a_i(sum_o), .b_i(ambient_term), .select_b_i(first_i), .y_o(sum_before)
  );
  blysk_lighting_q12_add_uq8_16_uq8_16_to_uq9_16 add_diffuse (
      .a_i(sum_before), .b_i(diffuse_term), .carry_i(ground_i), .s_o(lit)
  );
  blysk_lighting_q12_add_uq9_16_uq8_16_to_uq10_16 add_specular (
      .a_i(lit), .b_i(specular_term), .carry_i(ground_i), .s_o(sum)
  );
  blysk_lighting_q12_quantise_uq10_16_to_uq8_16_clamp saturate (.a_i(sum), .y_o(level));
  blysk_lighting_q12_quantise_uq8_16_to_uq8_0 round (.a_i(sum_o), .y_o(channel_o));

endmodule

`default_nettype wire
