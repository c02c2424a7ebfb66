// SPDX-License-Identifier: Apache-2.0
// device gouraud, format q8, 8 shifts, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: a scan line between two colours, its increments by shifts
//   digest: sha256:3fc8fbb8cd87296d41e25ffc912d330264d61711c4ab9ef0122f502a69325e9c
//   iCE40: 427 LUT, 191 carry, 182 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 428 LUT, 191 carry, 182 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 112.02 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 2591.4 NAND2, 1910 cells, longest path 3.649 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_gouraud_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] length_i,  // pixels from the left end to the right one, UQ10.0, codes 1..1023
    input  wire [7:0] r0_i,  // red at the left end, UQ8.0
    input  wire [7:0] g0_i,  // green at the left end, UQ8.0
    input  wire [7:0] b0_i,  // blue at the left end, UQ8.0
    input  wire [7:0] r1_i,  // red at the right end, UQ8.0
    input  wire [7:0] g1_i,  // green at the right end, UQ8.0
    input  wire [7:0] b1_i,  // blue at the right end, UQ8.0
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire [7:0] r_o,  // red of the pixel, UQ8.0
    output wire [7:0] g_o,  // green of the pixel, UQ8.0
    output wire [7:0] b_o,  // blue of the pixel, UQ8.0
    output wire valid_o  // a pixel is at the outputs
);

  wire load;
  wire step;
  wire digit;
  wire [8:0] digits;  // rom_digits: UQ1.8, codes 0..256
  wire one_in;  // one: UQ1.0
  wire ground_in;  // ground: UQ1.0

  blysk_gouraud_q8_gouraud_channel_gouraud_formats_q8 red (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit), .one_i(one_in), .ground_i(ground_in), .left_i(r0_i), .right_i(r1_i), .pixel_o(r_o)
  );
  blysk_gouraud_q8_gouraud_channel_gouraud_formats_q8 green (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit), .one_i(one_in), .ground_i(ground_in), .left_i(g0_i), .right_i(g1_i), .pixel_o(g_o)
  );
  blysk_gouraud_q8_gouraud_channel_gouraud_formats_q8 blue (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .draw_i(valid_o), .digit_i(digit), .one_i(one_in), .ground_i(ground_in), .left_i(b0_i), .right_i(b1_i), .pixel_o(b_o)
  );
  blysk_gouraud_q8_line_control_uq10_0 #(.STEPS(7'd8)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .length_i(length_i), .load_o(load), .step_o(step), .draw_o(valid_o), .ready_o(ready_o)
  );  // 8
  blysk_gouraud_q8_digit_register_uq1_8 rg_digits (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(digits), .digit_o(digit)
  );
  blysk_gouraud_q8_rom_uq10_0_to_uq1_8 rom_digits (.a_i(length_i), .y_o(digits));
  blysk_gouraud_q8_constant_uq1_0 #(.RAW(1'd1)) one (.y_o(one_in));  // 1
  blysk_gouraud_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(ground_in));  // 0

endmodule

`default_nettype wire
