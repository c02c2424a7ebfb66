// SPDX-License-Identifier: Apache-2.0
// device quadratic-interpolation, format q8, 8 fraction bits, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: a scan line of a quadratic polynomial, by forward differences
//   digest: sha256:a6e8cfa63eb3eb9458129699204c65b8e5b222dc1b2e8996c109ba17ada8e596
//   iCE40: 395 LUT, 270 carry, 188 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 395 LUT, 270 carry, 188 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 93.19 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 2741.9 NAND2, 2066 cells, longest path 5.25 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_quadratic_interpolation_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] length_i,  // pixels after the first, UQ10.0
    input  wire [15:0] r_i,  // red of the first pixel, UQ8.8
    input  wire signed [16:0] dr_i,  // its first difference, SQ8.8
    input  wire signed [8:0] ddr_i,  // its second difference, SQ0.8
    input  wire [15:0] g_i,  // green of the first pixel, UQ8.8
    input  wire signed [16:0] dg_i,  // its first difference, SQ8.8
    input  wire signed [8:0] ddg_i,  // its second difference, SQ0.8
    input  wire [15:0] b_i,  // blue of the first pixel, UQ8.8
    input  wire signed [16:0] db_i,  // its first difference, SQ8.8
    input  wire signed [8:0] ddb_i,  // its second difference, SQ0.8
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire [7:0] r_o,  // red of the pixel, UQ8.0
    output wire [7:0] g_o,  // green of the pixel, UQ8.0
    output wire [7:0] b_o,  // blue of the pixel, UQ8.0
    output wire valid_o  // a pixel is at the outputs
);

  wire load;
  wire ground_in;  // ground: UQ1.0

  blysk_quadratic_interpolation_q8_forward_differences_quadratic_interpolation_formats_q8 red (
      .clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(ground_in), .value_i(r_i), .first_i(dr_i), .second_i(ddr_i), .pixel_o(r_o)
  );
  blysk_quadratic_interpolation_q8_forward_differences_quadratic_interpolation_formats_q8 green (
      .clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(ground_in), .value_i(g_i), .first_i(dg_i), .second_i(ddg_i), .pixel_o(g_o)
  );
  blysk_quadratic_interpolation_q8_forward_differences_quadratic_interpolation_formats_q8 blue (
      .clk(clk), .rst_n(rst_n), .load_i(load), .draw_i(valid_o), .ground_i(ground_in), .value_i(b_i), .first_i(db_i), .second_i(ddb_i), .pixel_o(b_o)
  );
  blysk_quadratic_interpolation_q8_pixel_counter_uq10_0 control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .length_i(length_i), .load_o(load), .draw_o(valid_o), .ready_o(ready_o)
  );
  blysk_quadratic_interpolation_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(ground_in));  // 0

endmodule

`default_nettype wire
