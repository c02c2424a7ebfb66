// SPDX-License-Identifier: Apache-2.0
// device restoring-divider, format q8, 16 digits, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: division of a difference by a run length, a digit each clock cycle
//   digest: sha256:26b8b5a51b2eb8977303f5b26f1f35fc3f894d64f4c1c7edd57454a991b3334c
//   iCE40: 222 LUT, 62 carry, 62 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 with DSP: 222 LUT, 62 carry, 62 FF, 0 DSP, 0 RAM bits; Yosys 0.23 (git sha1 7ce5011c24b)
//   iCE40 HX8K: 85.19 MHz, the least of 5 seeds; nextpnr-ice40 -- Next Generation Place and Route (Version 0.4-1+b1), Yosys 0.23 (git sha1 7ce5011c24b)
//   OSU018: 787.6 NAND2, 561 cells, longest path 3.862 ns; OpenSTA 2.0.17, Yosys 0.23 (git sha1 7ce5011c24b)
//   not known with these options: errors, certificate, settling
`default_nettype none

module blysk_restoring_divider_q8 (
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
  wire was_negative;
  wire [16:0] quotient;  // div: UQ1.16
  wire is_negative;
  wire [7:0] size;  // mag_difference: UQ8.0
  wire [7:0] dividend;  // fraction_of: UQ0.8
  wire [16:0] increment_size;  // whole_of: UQ9.8

  blysk_restoring_divider_q8_sequencer #(.STEPS(7'd16)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 16
  blysk_restoring_divider_q8_pipe_1 rg_sign (
      .clk(clk), .rst_n(rst_n), .go_i(load), .d_i(is_negative), .q_o(was_negative)
  );
  blysk_restoring_divider_q8_divide_steps_uq0_8_uq10_0_to_uq1_16 div (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .a_i(dividend), .b_i(length_i), .q_o(quotient)
  );
  blysk_restoring_divider_q8_sign_sq8_0 sign_of (.a_i(difference_i), .negative_o(is_negative));
  blysk_restoring_divider_q8_magnitude_sq8_0_to_uq8_0 mag_difference (.a_i(difference_i), .y_o(size));
  blysk_restoring_divider_q8_move_point_uq8_0_to_uq0_8 fraction_of (.a_i(size), .y_o(dividend));
  blysk_restoring_divider_q8_move_point_uq1_16_to_uq9_8 whole_of (.a_i(quotient), .y_o(increment_size));
  blysk_restoring_divider_q8_with_sign_uq9_8_to_sq8_8 sign_quotient (
      .a_i(increment_size), .negative_i(was_negative), .y_o(increment_o)
  );

endmodule

`default_nettype wire
