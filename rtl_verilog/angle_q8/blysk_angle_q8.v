// SPDX-License-Identifier: Apache-2.0
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: cos^k of a multiple of the angle, along a scan line of angles
//   digest: sha256:230a936e46b601e5696dba82eb766dbadb1363571dc71ba1794fb44180391e3f
//   iCE40: 2062 LUT, 142 carry, 93 FF, 0 DSP, 20480 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 1171 LUT, 130 carry, 93 FF, 2 DSP, 20480 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 18.67 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 7183.5 NAND2, 6686 cells, longest path 15.364 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_angle_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire [9:0] n_i,  // n, to register 5, UQ10.0, codes 1..1000
    input  wire [7:0] intensity_i,  // intensity, to register 1, UQ8.0
    input  wire [18:0] angle_i,  // angle of the first pixel, rad, to register 3, UQ1.18, codes 0..411774
    input  wire signed [15:0] step_i,  // from pixel to pixel, rad, to register 2, SQ-3.18
    input  wire [9:0] count_i,  // pixels of the line, to the counter, UQ10.0, codes 1..1023
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // the line has ended, start_i takes the next
    output wire [15:0] out_o,  // intensity of the pixel, UQ8.8
    output wire valid_o  // a pixel is at the output
);

  wire load;
  wire first;
  wire advance;
  wire [7:0] intensity;  // rg1: UQ8.0
  wire signed [15:0] step;  // rg2: SQ-3.18
  wire [18:0] start_angle;  // rg3: UQ1.18, codes 0..411774
  wire signed [26:0] current_angle;  // rg4: SQ8.18
  wire [9:0] n;  // rg5: UQ10.0, codes 1..1000
  wire last;
  wire [3:0] part;  // dec: UQ4.0
  wire ground_in;  // ground: UQ1.0
  wire signed [26:0] sum;  // add4: SQ8.18
  wire signed [26:0] next_angle;  // mux: SQ8.18
  wire [25:0] distance;  // mag4: UQ8.18
  wire [15:0] limited;  // limit4: UQ1.15
  wire [17:0] factor;  // rom2: UQ5.13
  wire [33:0] turned;  // mul2: UQ6.28
  wire [9:0] place;  // quant2: UQ1.9, codes 0..512
  wire [8:0] brdf;  // rom1: UQ1.8, codes 0..256

  blysk_angle_q8_scan_control control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .carry_i(last), .load_o(load), .first_o(first), .step_o(advance), .draw_o(valid_o), .ready_o(ready_o)
  );
  blysk_angle_q8_reg_level_uq8_0 rg1 (
      .clk(clk), .rst_n(rst_n), .d_i(intensity_i), .we_i(load), .q_o(intensity)
  );
  blysk_angle_q8_reg_level_sqm3_18 rg2 (.clk(clk), .rst_n(rst_n), .d_i(step_i), .we_i(load), .q_o(step));
  blysk_angle_q8_reg_level_uq1_18 rg3 (.clk(clk), .rst_n(rst_n), .d_i(angle_i), .we_i(load), .q_o(start_angle));
  blysk_angle_q8_reg_level_sq8_18 rg4 (
      .clk(clk), .rst_n(rst_n), .d_i(next_angle), .we_i(advance), .q_o(current_angle)
  );
  blysk_angle_q8_reg_level_uq10_0 rg5 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(load), .q_o(n));
  blysk_angle_q8_down_counter_uq10_0 cnt (
      .clk(clk), .rst_n(rst_n), .load_i(load), .count_i(valid_o), .d_i(count_i), .carry_o(last)
  );
  blysk_angle_q8_part_decoder_uq10_0_to_uq4_0 #(.FIRST(64'd5)) dec (.n_i(n), .part_o(part));  // 5
  blysk_angle_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(ground_in));  // 0
  blysk_angle_q8_add_sq8_18_sqm3_18_to_sq8_18 add4 (
      .a_i(current_angle), .b_i(step), .carry_i(ground_in), .s_o(sum)
  );
  blysk_angle_q8_multiplexer_sq8_18_uq1_18_to_sq8_18 mux (
      .a_i(sum), .b_i(start_angle), .select_b_i(first), .y_o(next_angle)
  );
  blysk_angle_q8_magnitude_sq8_18_to_uq8_18 mag4 (.a_i(current_angle), .y_o(distance));
  blysk_angle_q8_quantise_uq8_18_to_uq1_15_clamp limit4 (.a_i(distance), .y_o(limited));
  blysk_angle_q8_filled_rom_uq10_0_to_uq5_13 rom2 (.a_i(n), .y_o(factor));
  blysk_angle_q8_mul_uq1_15_uq5_13_to_uq6_28 mul2 (.a_i(limited), .b_i(factor), .p_o(turned));
  blysk_angle_q8_quantise_uq6_28_to_uq1_9_clamp quant2 (.a_i(turned), .y_o(place));
  blysk_angle_q8_parted_rom_uq4_0_uq1_9_to_uq1_8 rom1 (.part_i(part), .a_i(place), .y_o(brdf));
  blysk_angle_q8_mul_uq1_8_uq8_0_to_uq8_8 mul1 (.a_i(brdf), .b_i(intensity), .p_o(out_o));

endmodule

`default_nettype wire
