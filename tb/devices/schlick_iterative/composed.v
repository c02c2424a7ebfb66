// SPDX-License-Identifier: Apache-2.0
// Schlick's lobe with the divider in time, block for block: brdf = c / (n (1 - c) + c); see tb/cosim/composition.
//
// Proved is the recurrence of the division, digit by digit. That it gives the quotient is not: blocks.division and
// cosim.schlick-iterative.all compare it with the quotient.
`include "iterative.vh"

  wire one, zero;
  wire [F+1:0] minus_c;
  wire [F:0] versine;
  wire [F+9:0] drop, divisor;
  wire [F+1:0] quotient;

  wired #(.VALUE(1)) node1 (.y_o(one));
  wired #(.VALUE(0)) ground (.y_o(zero));
  inverters #(.A(F + 1), .Y(F + 2)) inv_cos (.a_i(c), .y_o(minus_c));
  adder #(.AU(F), .B(F + 2), .BS(1), .S(F + 1)) add_cos
      (.a_i(one), .b_i(minus_c), .carry_i(one), .s_o(versine));
  multiplier #(.A(10), .B(F + 1), .P(F + 10)) mul_n (.a_i(n), .b_i(versine), .p_o(drop));
  adder #(.A(F + 10), .B(F + 1), .S(F + 10)) add_divisor
      (.a_i(drop), .b_i(c), .carry_i(zero), .s_o(divisor));
  divide_steps #(.A(F + 1), .B(F + 10), .Q(F + 2)) div (.clk(clk), .rst_n(rst_n), .load_i(first), .step_i(step),
      .a_i(c), .b_i(divisor), .q_o(quotient));
  round_off #(.A(F + 2), .DROP(1), .Y(F + 1)) quant (.a_i(quotient), .y_o(brdf));

endmodule
