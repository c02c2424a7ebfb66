// SPDX-License-Identifier: Apache-2.0
// device arccos, format q24, 30 digits of the root, table of 4097 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: the angle of a cosine, by a square root and a table
//   digest: sha256:479cb5fc3932c4e372d8e863f6d8a5d85c2dee91e79b6f2bed2b252f55cbec65
//   not known with these options: errors, certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_arccos_q24 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [24:0] cos_i,  // cosine, 0..1, UQ1.24, codes 0..16777216
    input  wire start_i,  // takes the cosine while ready_o is one
    output wire ready_o,  // start_i takes the cosine
    output wire [26:0] angle_o,  // its angle, rad, UQ1.26
    output wire valid_o  // angle_o is valid
);

  wire load;
  wire step;
  wire [24:0] versine;  // rg_versine: UQ1.24, codes 0..16777216
  wire [29:0] root_of_versine;  // root: UQ1.29
  wire [24:0] versine_in;  // sub: UQ1.24, codes 0..16777216
  wire [29:0] ratio;  // line: UQ1.29

  blysk_arccos_q24_sequencer #(.STEPS(7'd30)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 30
  blysk_arccos_q24_reg_level_uq1_24 rg_versine (
      .clk(clk), .rst_n(rst_n), .d_i(versine_in), .we_i(load), .q_o(versine)
  );
  blysk_arccos_q24_square_root_steps_uq1_24_to_uq1_29 root (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(versine_in), .root_o(root_of_versine)
  );
  blysk_arccos_q24_one_minus_uq1_24 sub (.a_i(cos_i), .y_o(versine_in));
  blysk_arccos_q24_line_table_uq1_24_to_uq1_29 line (.a_i(versine), .y_o(ratio));
  blysk_arccos_q24_mul_uq1_29_uq1_29_to_uq1_26 mul_angle (.a_i(root_of_versine), .b_i(ratio), .p_o(angle_o));

endmodule

`default_nettype wire
