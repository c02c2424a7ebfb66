// SPDX-License-Identifier: Apache-2.0
// A quotient of two lines with the divider in time, block for block: brdf = max(0, 1 - r u) / (1 + d u), u = 1 - c, r and d
// from memories; see tb/cosim/composition.
//
// Proved is the recurrence of the division, digit by digit. That it gives the quotient is not: blocks.division and
// cosim.rational-iterative.all compare it with the quotient.
`include "iterative.vh"

  wire one, zero;
  wire [F:0] u;
  wire [F+9:0] r_of_n;
  wire [F+10:0] d_of_n;
  wire [F+11:0] drop;
  wire [F+12:0] minus_drop, line, climb, sum;
  wire [F+3:0] dividend;
  wire [F+5:0] divisor;
  wire [F+1:0] quotient;

  wired #(.VALUE(1)) node1 (.y_o(one));
  wired #(.VALUE(0)) ground (.y_o(zero));
  memory #(.A(10), .Y(F + 10)) rom_fall (.a_i(n), .y_o(r_of_n));
  memory #(.A(10), .Y(F + 11)) rom_rise (.a_i(n), .y_o(d_of_n));
  one_minus #(.A(F + 1)) sub_cos (.a_i(c), .y_o(u));
  // r and d have F + 1 fraction bits, their products with u are rounded to F + 3.
  multiplier #(.A(F + 10), .B(F + 1), .P(F + 12), .DROP(F - 2)) mul_fall (.a_i(r_of_n), .b_i(u), .p_o(drop));
  inverters #(.A(F + 12), .Y(F + 13)) inv_drop (.a_i(drop), .y_o(minus_drop));
  adder #(.AU(F + 3), .B(F + 13), .BS(1), .S(F + 13)) add_line
      (.a_i(one), .b_i(minus_drop), .carry_i(one), .s_o(line));
  rounding #(.A(F + 13), .AS(1), .Y(F + 4), .MOST(1 << (F + 3))) quant_line (.a_i(line), .y_o(dividend));
  multiplier #(.A(F + 11), .B(F + 1), .P(F + 13), .DROP(F - 2)) mul_rise (.a_i(d_of_n), .b_i(u), .p_o(climb));
  adder #(.AU(F + 3), .B(F + 13), .S(F + 13)) add_sum (.a_i(one), .b_i(climb), .carry_i(zero), .s_o(sum));
  rounding #(.A(F + 13), .Y(F + 6)) quant_sum (.a_i(sum), .y_o(divisor));
  divide_steps #(.A(F + 4), .B(F + 6), .Q(F + 2)) div (.clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step),
      .a_i(dividend), .b_i(divisor), .q_o(quotient));
  round_off #(.A(F + 2), .DROP(1), .Y(F + 1)) quant (.a_i(quotient), .y_o(brdf));

endmodule
