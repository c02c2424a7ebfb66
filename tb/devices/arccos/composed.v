// SPDX-License-Identifier: Apache-2.0
// angle = sqrt(v) r(v), v = 1 - cos, F fraction bits, F even; see tb/cosim/composition. The root has F + 5 fraction
// bits, the angle F + 2.
//
// Proved is the recurrence of the root, digit by digit. That it gives the root is not: blocks.scan compares it with
// floor(sqrt) for all radicands of a narrow format. The table r(v) is cut out with its straight lines: unit.arccos
// compares its words, and the angle of every cosine of q8 to q20, in the bit-accurate model; cosim.arccos.all compares
// the Verilog with that.
`default_nettype none

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [F:0] cos_i,
    input wire start_i,
    output wire ready_o,
    output wire [F+2:0] angle_o,
    output wire valid_o
);

  wire load, step;
  wire [F:0] versine_in, versine;
  wire [F+5:0] root_of_versine, ratio;

  sequencer #(.STEPS(F + 6)) control (.clk(clk), .rst_n(rst_n), .start_i(start_i),
      .load_o(load), .step_o(step), .ready_o(ready_o), .done_o(valid_o));
  one_minus #(.A(F + 1)) sub (.a_i(cos_i), .y_o(versine_in));
  register #(.D(F + 1)) rg_versine (.clk(clk), .rst_n(rst_n), .d_i(versine_in), .we_i(load), .q_o(versine));
  square_root_steps #(.F(F), .Q(F + 6)) root
      (.clk(clk), .rst_n(rst_n), .load_i(load), .step_i(step), .d_i(versine_in), .root_o(root_of_versine));
  memory #(.A(F + 1), .Y(F + 6)) line (.a_i(versine), .y_o(ratio));
  multiplier #(.A(F + 6), .B(F + 6), .P(F + 3), .DROP(F + 8)) mul_angle
      (.a_i(root_of_versine), .b_i(ratio), .p_o(angle_o));

endmodule

`default_nettype wire
