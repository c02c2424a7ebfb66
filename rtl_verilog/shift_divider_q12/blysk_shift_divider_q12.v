// SPDX-License-Identifier: Apache-2.0
// device shift-divider, format q12, 12 shifts, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: division of a difference by a run length, by shifts and additions
//   digest: sha256:e1f2ec97d14e5a944d5783fb8aedfea0282fb822836f8992b1207a9de35f28ba
//   not known with these options: errors, certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_shift_divider_q12 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire signed [8:0] difference_i,  // difference of the intensities at the ends, SQ8.0, codes -255..255
    input  wire [9:0] length_i,  // pixels between the ends, UQ10.0, codes 1..1023
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire signed [20:0] increment_o,  // difference / length, SQ8.12
    output wire valid_o  // increment_o is valid
);

  wire load;
  wire step;
  wire digit;
  wire signed [19:0] shifted;  // rg_shift: SQ7.12
  wire [12:0] digits;  // rom_digits: UQ1.12, codes 0..4096
  wire carry_in;  // ground: UQ1.0
  wire signed [20:0] sum;  // add_sum: SQ8.12

  blysk_shift_divider_q12_sequencer #(.STEPS(7'd12)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 12
  blysk_shift_divider_q12_digit_register_uq1_12 rg_digits (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(digits), .digit_o(digit)
  );
  blysk_shift_divider_q12_shift_register_sq8_0_to_sq7_12 rg_shift (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(difference_i), .q_o(shifted)
  );
  blysk_shift_divider_q12_sum_register_sq8_0_sq8_12_to_sq8_12 rg_sum (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .add_i(digit), .d_i(difference_i), .sum_i(sum), .q_o(increment_o)
  );
  blysk_shift_divider_q12_rom_uq10_0_to_uq1_12 rom_digits (.a_i(length_i), .y_o(digits));
  blysk_shift_divider_q12_constant_uq1_0 #(.RAW(1'd0)) ground (.y_o(carry_in));  // 0
  blysk_shift_divider_q12_add_sq8_12_sq7_12_to_sq8_12 add_sum (
      .a_i(increment_o), .b_i(shifted), .carry_i(carry_in), .s_o(sum)
  );

endmodule

`default_nettype wire
