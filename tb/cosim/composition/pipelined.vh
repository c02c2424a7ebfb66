// SPDX-License-Identifier: Apache-2.0
// Begins the composed.v of a pipelined device that shades a point: its ports, registers 1..5, control, and what the colours
// and their multipliers have. STAGES is defined before: clock edges from the one that takes a point to the one that shows its
// result. n and c are in registers 1 and 2; the device's own text makes brdf, of F fraction bits, for the last stage.
module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] n_i,
    input wire [F:0] cos_i,
    input wire [7:0] r_i, g_i, b_i,
    input wire start_i, stall_i,
    output wire ready_o,
    output wire [F+7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire go, take;
  wire [9:0] n;
  wire [F:0] c, brdf;
  wire [7:0] r, g, b, r_last, g_last, b_last;

  pipe_control control
      (.start_i(start_i), .stall_i(stall_i), .valid_i(valid_o), .go_o(go), .take_o(take), .ready_o(ready_o));
  pipe #(.LENGTH(`STAGES)) pipe_valid (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(start_i), .q_o(valid_o));
  register #(.D(10)) rg1 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(take), .q_o(n));
  register #(.D(F + 1)) rg2 (.clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(take), .q_o(c));
  register #(.D(8)) rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(take), .q_o(r));
  register #(.D(8)) rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(take), .q_o(g));
  register #(.D(8)) rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(take), .q_o(b));

  pipe #(.D(8), .LENGTH(`STAGES - 1)) pipe_r (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(r), .q_o(r_last));
  pipe #(.D(8), .LENGTH(`STAGES - 1)) pipe_g (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(g), .q_o(g_last));
  pipe #(.D(8), .LENGTH(`STAGES - 1)) pipe_b (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(b), .q_o(b_last));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul12 (.a_i(brdf), .b_i(r_last), .p_o(r_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul13 (.a_i(brdf), .b_i(g_last), .p_o(g_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) mul14 (.a_i(brdf), .b_i(b_last), .p_o(b_o));

