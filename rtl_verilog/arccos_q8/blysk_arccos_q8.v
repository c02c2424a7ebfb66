// SPDX-License-Identifier: Apache-2.0
// device arccos, format q8, 14 digits of the root, table of 17 words, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: the angle of a cosine, by a square root and a table
//   digest: sha256:f4ade110c8cd4243b4765b2aeb34b341347b104623dc8e41faa266aa2a5dd2c0
//   iCE40: 733 LUT, 79 carry, 76 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 187 LUT, 53 carry, 76 FF, 2 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 44.76 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 2246.8 NAND2, 1998 cells, longest path 7.837 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_arccos_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [8:0] cos_i,  // cosine, 0..1, UQ1.8, codes 0..256
    input  wire start_i,  // takes the cosine while ready_o is one
    output wire ready_o,  // start_i takes the cosine
    output wire [10:0] angle_o,  // its angle, rad, UQ1.10
    output wire valid_o  // angle_o is valid
);

  wire load;
  wire step;
  wire [8:0] versine;  // rg_versine: UQ1.8, codes 0..256
  wire [13:0] root_of_versine;  // root: UQ1.13
  wire [8:0] versine_in;  // sub: UQ1.8, codes 0..256
  wire [13:0] ratio;  // line: UQ1.13

  blysk_arccos_q8_sequencer #(.STEPS(7'd14)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 14
  blysk_arccos_q8_reg_level_uq1_8 rg_versine (
      .clk(clk), .rst_n(rst_n), .d_i(versine_in), .we_i(load), .q_o(versine)
  );
  blysk_arccos_q8_square_root_steps_uq1_8_to_uq1_13 root (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(versine_in), .root_o(root_of_versine)
  );
  blysk_arccos_q8_one_minus_uq1_8 sub (.a_i(cos_i), .y_o(versine_in));
  blysk_arccos_q8_line_table_uq1_8_to_uq1_13 line (.a_i(versine), .y_o(ratio));
  blysk_arccos_q8_mul_uq1_13_uq1_13_to_uq1_10 mul_angle (.a_i(root_of_versine), .b_i(ratio), .p_o(angle_o));

endmodule

`default_nettype wire
