// SPDX-License-Identifier: Apache-2.0
// Begins the composed.v of a device with the strobes of fig. 3: its ports, registers 1..5 and multipliers 12..14. c is
// cos(delta); the device's own text makes brdf, of F fraction bits, of n and c. Instances are called as in [P] fig. 1 unless
// the device has defined other names before.
`ifndef RG_N
`define RG_N rg1
`define RG_COS rg2
`define BUF_VALID buf29
`define MUL_RED mul12
`define MUL_GREEN mul13
`define MUL_BLUE mul14
`endif
module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] n_i,
    input wire n_we_i,
    input wire [F:0] cos_i,
    input wire cos_we_i,
    input wire [7:0] r_i,
    input wire r_we_i,
    input wire [7:0] g_i,
    input wire g_we_i,
    input wire [7:0] b_i,
    input wire b_we_i,
    output wire [F+7:0] r_o, g_o, b_o,
    output wire valid_o
);

  wire [9:0] n;
  wire [F:0] c, brdf;
  wire [7:0] r, g, b;

  register #(.D(10)) `RG_N (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(n_we_i), .q_o(n));
  register_trailing #(.D(F + 1)) `RG_COS (.clk(clk), .rst_n(rst_n), .d_i(cos_i), .we_i(cos_we_i), .q_o(c));
  register #(.D(8)) rg3 (.clk(clk), .rst_n(rst_n), .d_i(r_i), .we_i(r_we_i), .q_o(r));
  register #(.D(8)) rg4 (.clk(clk), .rst_n(rst_n), .d_i(g_i), .we_i(g_we_i), .q_o(g));
  register #(.D(8)) rg5 (.clk(clk), .rst_n(rst_n), .d_i(b_i), .we_i(b_we_i), .q_o(b));
  wires `BUF_VALID (.a_i(cos_we_i), .y_o(valid_o));

  multiplier #(.A(F + 1), .B(8), .P(F + 8)) `MUL_RED (.a_i(brdf), .b_i(r), .p_o(r_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) `MUL_GREEN (.a_i(brdf), .b_i(g), .p_o(g_o));
  multiplier #(.A(F + 1), .B(8), .P(F + 8)) `MUL_BLUE (.a_i(brdf), .b_i(b), .p_o(b_o));

