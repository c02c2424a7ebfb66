// SPDX-License-Identifier: Apache-2.0
// increment = difference / length with F fraction bits, cut towards 0; see tb/cosim/composition. 2^-8 |difference|,
// which is less than any length, is divided, to F + 8 fraction bits.
//
// Proved is the recurrence of the division, digit by digit. That it gives the quotient is not: unit.restoring-divider
// and blocks.division compare it with division of integers.
`default_nettype none

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [8:0] difference_i,
    input wire [9:0] length_i,
    input wire start_i,
    output wire ready_o,
    output wire [F+8:0] increment_o,
    output wire valid_o
);

  wire load, step, is_negative, was_negative;
  wire [7:0] size, dividend;
  wire [F+8:0] quotient, increment_size;

  sequencer #(.STEPS(F + 8)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i),
      .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o));
  sign #(.A(9)) sign_of (.a_i(difference_i), .negative_o(is_negative));
  pipe #(.D(1)) rg_sign (.clk(clk), .rst_n(rst_n), .go_i(load), .d_i(is_negative), .q_o(was_negative));
  magnitude #(.A(9)) mag_difference (.a_i(difference_i), .y_o(size));
  wires #(.A(8)) fraction_of (.a_i(size), .y_o(dividend));
  divide_steps #(.A(8), .B(10), .BU(8), .Q(F + 9)) div (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step),
      .a_i(dividend), .b_i(length_i), .q_o(quotient));
  wires #(.A(F + 9)) whole_of (.a_i(quotient), .y_o(increment_size));
  with_sign #(.A(F + 9), .Y(F + 9)) sign_quotient
      (.a_i(increment_size), .negative_i(was_negative), .y_o(increment_o));

endmodule

`default_nettype wire
