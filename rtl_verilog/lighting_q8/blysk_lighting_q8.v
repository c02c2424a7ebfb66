// SPDX-License-Identifier: Apache-2.0
// device lighting, format q8, no energy factor, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: the colour of a pixel, light by light, beside a specular device
//   digest: sha256:678e6f32c37453ae77414e5e3255435adb42594486b79496be267c7f2c5f2ed9
//   iCE40: 1456 LUT, 223 carry, 73 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 298 LUT, 147 carry, 73 FF, 3 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 50.28 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 4379.4 NAND2, 4208 cells, longest path 6.315 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_lighting_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [8:0] nl_i,  // N.L, 0..1, UQ1.8, codes 0..256
    input  wire first_i,  // 1: the first light of a pixel, UQ1.0
    input  wire [15:0] ar_i,  // I_a k_a, red, UQ8.8, codes 0..65280
    input  wire [15:0] ag_i,  // I_a k_a, green, UQ8.8, codes 0..65280
    input  wire [15:0] ab_i,  // I_a k_a, blue, UQ8.8, codes 0..65280
    input  wire [15:0] dr_i,  // I_l k_d, red, UQ8.8, codes 0..65280
    input  wire [15:0] dg_i,  // I_l k_d, green, UQ8.8, codes 0..65280
    input  wire [15:0] db_i,  // I_l k_d, blue, UQ8.8, codes 0..65280
    input  wire [15:0] sr_i,  // output 25 of a specular device, UQ8.8, codes 0..65280
    input  wire [15:0] sg_i,  // output 26 of a specular device, UQ8.8, codes 0..65280
    input  wire [15:0] sb_i,  // output 27 of a specular device, UQ8.8, codes 0..65280
    input  wire start_i,  // takes a light while ready_o is one
    input  wire stall_i,  // keeps a result at the outputs
    output wire ready_o,  // start_i takes a light
    output wire [23:0] r_sum_o,  // red, with its fraction, UQ8.16, codes 0..16711680
    output wire [23:0] g_sum_o,  // green, with its fraction, UQ8.16, codes 0..16711680
    output wire [23:0] b_sum_o,  // blue, with its fraction, UQ8.16, codes 0..16711680
    output wire [7:0] r_o,  // red of the pixel, UQ8.0
    output wire [7:0] g_o,  // green of the pixel, UQ8.0
    output wire [7:0] b_o,  // blue of the pixel, UQ8.0
    output wire valid_o  // a result is at the outputs
);

  wire go;
  wire take;
  wire ground_in;  // ground: UQ1.0

  blysk_lighting_q8_lighting_channel_lighting_formats_q8_false red (
      .clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(ground_in), .nl_i(nl_i), .ambient_i(ar_i), .diffuse_i(dr_i), .specular_i(sr_i), .sum_o(r_sum_o), .channel_o(r_o)
  );
  blysk_lighting_q8_lighting_channel_lighting_formats_q8_false green (
      .clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(ground_in), .nl_i(nl_i), .ambient_i(ag_i), .diffuse_i(dg_i), .specular_i(sg_i), .sum_o(g_sum_o), .channel_o(g_o)
  );
  blysk_lighting_q8_lighting_channel_lighting_formats_q8_false blue (
      .clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(ground_in), .nl_i(nl_i), .ambient_i(ab_i), .diffuse_i(db_i), .specular_i(sb_i), .sum_o(b_sum_o), .channel_o(b_o)
  );
  blysk_lighting_q8_pipe_1 pipe_valid (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o));
  blysk_lighting_q8_pipe_control control (
      .start_i(start_i), .stall_i(stall_i), .valid_i(valid_o), .go_o(go), .take_o(take), .ready_o(ready_o)
  );
  blysk_lighting_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(ground_in));  // 0

endmodule

`default_nettype wire
