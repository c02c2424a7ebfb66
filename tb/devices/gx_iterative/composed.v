// SPDX-License-Identifier: Apache-2.0
// The lobe of GX with the divider in time, block for block: brdf = c^2 / (n/2 (1 - c^2) + c^2); see tb/cosim/composition.
//
// Proved is the recurrence of the division, digit by digit. That it gives the quotient is not: blocks.division and
// cosim.gx-iterative.all compare it with the quotient.
`include "iterative.vh"

  // Fraction bits of c^2.
  localparam D = F < 12 ? 2 * F : F + 12;

  wire zero;
  wire [D:0] c2, rest;
  wire [9:0] half_n;
  wire [D+9:0] drop, divisor;
  wire [F+1:0] quotient;

  wired #(.VALUE(0)) ground (.y_o(zero));
  multiplier #(.A(F + 1), .B(F + 1), .P(D + 1), .DROP(2 * F - D)) mul_cos (.a_i(c), .b_i(c), .p_o(c2));
  one_minus #(.A(D + 1)) sub_square (.a_i(c2), .y_o(rest));
  // n/2 is n with one fraction bit.
  wires #(.A(10)) halve_n (.a_i(n), .y_o(half_n));
  multiplier #(.A(10), .B(D + 1), .P(D + 10)) mul_n (.a_i(half_n), .b_i(rest), .p_o(drop));
  adder #(.A(D + 10), .B(D + 1), .BU(1), .S(D + 10)) add_divisor
      (.a_i(drop), .b_i(c2), .carry_i(zero), .s_o(divisor));
  divide_steps #(.A(D + 1), .AU(1), .B(D + 10), .Q(F + 2)) div (.clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step),
      .a_i(c2), .b_i(divisor), .q_o(quotient));
  round_off #(.A(F + 2), .DROP(1), .Y(F + 1)) quant (.a_i(quotient), .y_o(brdf));

endmodule
