// SPDX-License-Identifier: Apache-2.0
// [T] fig. 2.13: increment = difference times F binary places of 1/length, by shifts and additions; see
// tb/cosim/composition.
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

  wire load, step, digit, zero;
  wire [F:0] digits;
  wire [F+7:0] shifted;
  wire [F+8:0] sum;

  sequencer #(.STEPS(F)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i),
      .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o));
  memory #(.A(10), .Y(F + 1)) rom_digits (.a_i(length_i), .y_o(digits));
  digit_register #(.D(F + 1)) rg_digits
      (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(digits), .digit_o(digit));
  shift_register #(.D(9), .DU(F), .Q(F + 8)) rg_shift
      (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(difference_i), .q_o(shifted));
  wired #(.VALUE(0)) ground (.y_o(zero));
  adder #(.A(F + 9), .AS(1), .B(F + 8), .BS(1), .S(F + 9)) add_sum
      (.a_i(increment_o), .b_i(shifted), .carry_i(zero), .s_o(sum));
  sum_register #(.D(9), .DU(F), .Q(F + 9)) rg_sum (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step),
      .add_i(digit), .d_i(difference_i), .sum_i(sum), .q_o(increment_o));

endmodule

`default_nettype wire
