// SPDX-License-Identifier: Apache-2.0
// device arccos, format q16, 22 digits of the root, table of 257 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: the angle of a cosine, by a square root and a table
//   digest: sha256:2c95670479acb2637f11653176f034025a576a6021cb1860eda817d1cc33a902
//   not known with these options: errors, certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_arccos_q16 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [16:0] cos_i,  // cosine, 0..1, UQ1.16, codes 0..65536
    input  wire start_i,  // takes the cosine while ready_o is one
    output wire ready_o,  // start_i takes the cosine
    output wire [18:0] angle_o,  // its angle, rad, UQ1.18
    output wire valid_o  // angle_o is valid
);

  wire load;
  wire step;
  wire [16:0] versine;  // rg_versine: UQ1.16, codes 0..65536
  wire [21:0] root_of_versine;  // root: UQ1.21
  wire [16:0] versine_in;  // sub: UQ1.16, codes 0..65536
  wire [21:0] ratio;  // line: UQ1.21

  blysk_arccos_q16_sequencer #(.STEPS(7'd22)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 22
  blysk_arccos_q16_reg_level_uq1_16 rg_versine (
      .clk(clk), .rst_n(rst_n), .d_i(versine_in), .we_i(load), .q_o(versine)
  );
  blysk_arccos_q16_square_root_steps_uq1_16_to_uq1_21 root (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(versine_in), .root_o(root_of_versine)
  );
  blysk_arccos_q16_one_minus_uq1_16 sub (.a_i(cos_i), .y_o(versine_in));
  blysk_arccos_q16_line_table_uq1_16_to_uq1_21 line (.a_i(versine), .y_o(ratio));
  blysk_arccos_q16_mul_uq1_21_uq1_21_to_uq1_18 mul_angle (.a_i(root_of_versine), .b_i(ratio), .p_o(angle_o));

endmodule

`default_nettype wire
