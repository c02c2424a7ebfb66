// SPDX-License-Identifier: Apache-2.0
// The colour of a pixel, light by light: ambient, then + diffuse N.L + specular, limited to 0..255 after each light;
// see tb/cosim/composition. F fraction bits of N.L and of the specular terms, 16 of the sum. Without an energy factor.
`default_nettype none

module channel #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire take_i, first_i, ground_i,
    input wire [F:0] nl_i,
    input wire [15:0] ambient_i, diffuse_i,
    input wire [F+7:0] specular_i,
    output wire [23:0] sum_o,
    output wire [7:0] channel_o
);

  wire [23:0] ambient_term, diffuse_term, specular_term, sum_before, level;
  wire [24:0] lit;
  wire [25:0] sum;

  wires #(.A(16), .U(8), .Y(24)) ambient (.a_i(ambient_i), .y_o(ambient_term));
  multiplier #(.A(16), .B(F + 1), .P(24), .DROP(F - 8)) diffuse (.a_i(diffuse_i), .b_i(nl_i), .p_o(diffuse_term));
  rescale #(.A(F + 8), .FROM(F), .TO(16), .Y(24)) specular (.a_i(specular_i), .y_o(specular_term));
  multiplexer #(.A(24), .B(24)) base
      (.a_i(sum_o), .b_i(ambient_term), .select_b_i(first_i), .y_o(sum_before));
  adder #(.A(24), .B(24), .S(25)) add_diffuse (.a_i(sum_before), .b_i(diffuse_term), .carry_i(ground_i), .s_o(lit));
  adder #(.A(25), .B(24), .S(26)) add_specular (.a_i(lit), .b_i(specular_term), .carry_i(ground_i), .s_o(sum));
  rounding #(.A(26), .Y(24), .MOST(255 << 16)) saturate (.a_i(sum), .y_o(level));
  register #(.D(24)) accumulator (.clk(clk), .rst_n(rst_n), .d_i(level), .we_i(take_i), .q_o(sum_o));
  round_off #(.A(24), .DROP(16), .Y(8)) round (.a_i(sum_o), .y_o(channel_o));

endmodule

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [F:0] nl_i,
    input wire first_i,
    input wire [15:0] ar_i, ag_i, ab_i, dr_i, dg_i, db_i,
    input wire [F+7:0] sr_i, sg_i, sb_i,
    input wire start_i, stall_i,
    output wire ready_o,
    output wire [23:0] r_sum_o, g_sum_o, b_sum_o,
    output wire [7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire go, take, low;

  pipe_control control (.start_i(start_i), .stall_i(stall_i), .valid_i(valid_o),
      .go_o(go), .take_o(take), .ready_o(ready_o));
  pipe #(.D(1)) pipe_valid (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o));
  wired #(.VALUE(0)) ground (.y_o(low));
  channel #(.F(F)) red (.clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(low), .nl_i(nl_i),
      .ambient_i(ar_i), .diffuse_i(dr_i), .specular_i(sr_i), .sum_o(r_sum_o), .channel_o(r_o));
  channel #(.F(F)) green (.clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(low), .nl_i(nl_i),
      .ambient_i(ag_i), .diffuse_i(dg_i), .specular_i(sg_i), .sum_o(g_sum_o), .channel_o(g_o));
  channel #(.F(F)) blue (.clk(clk), .rst_n(rst_n), .take_i(take), .first_i(first_i), .ground_i(low), .nl_i(nl_i),
      .ambient_i(ab_i), .diffuse_i(db_i), .specular_i(sb_i), .sum_o(b_sum_o), .channel_o(b_o));

endmodule

`default_nettype wire
