// SPDX-License-Identifier: Apache-2.0
// device shift-divider, format q8, 8 shifts, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: division of a difference by a run length, by shifts and additions
//   digest: sha256:52f4589e61e17e19cfcd3452ab65fee09d0ff6e114af30d2ab6a11f03a78a87f
//   iCE40: 112 LUT, 21 carry, 49 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 112 LUT, 21 carry, 49 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 132.68 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 623.9 NAND2, 452 cells, longest path 3.497 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_shift_divider_q8 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire signed [8:0] difference_i,  // difference of the intensities at the ends, SQ8.0, codes -255..255
    input  wire [9:0] length_i,  // pixels between the ends, UQ10.0, codes 1..1023
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire signed [16:0] increment_o,  // difference / length, SQ8.8
    output wire valid_o  // increment_o is valid
);

  wire load;
  wire step;
  wire digit;
  wire signed [15:0] shifted;  // rg_shift: SQ7.8
  wire [8:0] digits;  // rom_digits: UQ1.8, codes 0..256
  wire carry_in;  // ground: UQ1.0
  wire signed [16:0] sum;  // add_sum: SQ8.8

  blysk_shift_divider_q8_sequencer #(.STEPS(7'd8)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 8
  blysk_shift_divider_q8_digit_register_uq1_8 rg_digits (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(digits), .digit_o(digit)
  );
  blysk_shift_divider_q8_shift_register_sq8_0_to_sq7_8 rg_shift (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(difference_i), .q_o(shifted)
  );
  blysk_shift_divider_q8_sum_register_sq8_0_sq8_8_to_sq8_8 rg_sum (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .add_i(digit), .d_i(difference_i), .sum_i(sum), .q_o(increment_o)
  );
  blysk_shift_divider_q8_rom_uq10_0_to_uq1_8 rom_digits (.a_i(length_i), .y_o(digits));
  blysk_shift_divider_q8_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(carry_in));  // 0
  blysk_shift_divider_q8_add_sq8_8_sq7_8_to_sq8_8 add_sum (
      .a_i(increment_o), .b_i(shifted), .carry_i(carry_in), .s_o(sum)
  );

endmodule

`default_nettype wire
