// SPDX-License-Identifier: Apache-2.0
// device restoring-divider, format q16, 24 digits, exported from the SystemC model.
// What blysk knows of it, and the digest of its modules without this comment:
//   computes: division of a difference by a run length, a digit each clock cycle
//   digest: sha256:55227d47723af55194e20d92d8cf0e3386d7591ceddac5da45ff09aa60f01706
//   not known with these options: errors, certificate, iCE40, iCE40 with DSP, iCE40 HX8K, OSU018, settling
`default_nettype none

module blysk_restoring_divider_q16 (
    input  wire clk,  // clock
    input  wire rst_n,  // synchronous, active low
    input  wire signed [8:0] difference_i,  // difference of the intensities at the ends, SQ8.0, codes -255..255
    input  wire [9:0] length_i,  // pixels between the ends, UQ10.0, codes 1..1023
    input  wire start_i,  // takes the inputs while ready_o is one
    output wire ready_o,  // start_i takes the inputs
    output wire signed [24:0] increment_o,  // difference / length, SQ8.16
    output wire valid_o  // increment_o is valid
);

  wire load;
  wire step;
  wire was_negative;
  wire [24:0] quotient;  // div: UQ1.24
  wire is_negative;
  wire [7:0] size;  // mag_difference: UQ8.0
  wire [7:0] dividend;  // fraction_of: UQ0.8
  wire [24:0] increment_size;  // whole_of: UQ9.16

  blysk_restoring_divider_q16_sequencer #(.STEPS(7'd24)) control (
      .clk(clk), .rst_n(rst_n), .start_i(start_i), .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o)
  );  // 24
  blysk_restoring_divider_q16_pipe_1 rg_sign (
      .clk(clk), .rst_n(rst_n), .go_i(load), .d_i(is_negative), .q_o(was_negative)
  );
  blysk_restoring_divider_q16_divide_steps_uq0_8_uq10_0_to_uq1_24 div (
      .clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .a_i(dividend), .b_i(length_i), .q_o(quotient)
  );
  blysk_restoring_divider_q16_sign_sq8_0 sign_of (.a_i(difference_i), .negative_o(is_negative));
  blysk_restoring_divider_q16_magnitude_sq8_0_to_uq8_0 mag_difference (.a_i(difference_i), .y_o(size));
  blysk_restoring_divider_q16_move_point_uq8_0_to_uq0_8 fraction_of (.a_i(size), .y_o(dividend));
  blysk_restoring_divider_q16_move_point_uq1_24_to_uq9_16 whole_of (.a_i(quotient), .y_o(increment_size));
  blysk_restoring_divider_q16_with_sign_uq9_16_to_sq8_16 sign_quotient (
      .a_i(increment_size), .negative_i(was_negative), .y_o(increment_o)
  );

endmodule

`default_nettype wire
