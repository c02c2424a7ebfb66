// SPDX-License-Identifier: Apache-2.0
// device arccos, format q12, 18 digits of the root, table of 65 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: the angle of a cosine, by a square root and a table
//   digest: sha256:3767f225a6545ea6ac56672e0de9a0c91db9a0866c16588bbdb05d416a12ad3c
//   not known with these options: errors, certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_arccos_q12 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [12:0] cos_i,  // cosine, 0..1, UQ1.12, codes 0..4096
    input  wire start_i,  // takes the cosine while ready_o is one
    output wire ready_o,  // start_i takes the cosine
    output wire [14:0] angle_o,  // its angle, rad, UQ1.14
    output wire valid_o  // angle_o is valid
);

  wire load;
  wire step;
  wire [12:0] versine;  // rg_versine: UQ1.12, codes 0..4096
  wire [17:0] root_of_versine;  // root: UQ1.17
  wire [12:0] versine_in;  // sub: UQ1.12, codes 0..4096
  wire [17:0] ratio;  // line: UQ1.17

  blysk_arccos_q12_sequencer #(.STEPS(7'd18)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 18
  blysk_arccos_q12_reg_level_uq1_12 rg_versine (
      .clk(clk), .rst_n(rst_n), .d_i(versine_in), .we_i(load), .q_o(versine)
  );
  blysk_arccos_q12_square_root_steps_uq1_12_to_uq1_17 root (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(versine_in), .root_o(root_of_versine)
  );
  blysk_arccos_q12_one_minus_uq1_12 sub (.a_i(cos_i), .y_o(versine_in));
  blysk_arccos_q12_line_table_uq1_12_to_uq1_17 line (.a_i(versine), .y_o(ratio));
  blysk_arccos_q12_mul_uq1_17_uq1_17_to_uq1_14 mul_angle (.a_i(root_of_versine), .b_i(ratio), .p_o(angle_o));

endmodule

`default_nettype wire
