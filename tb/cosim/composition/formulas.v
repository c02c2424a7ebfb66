// SPDX-License-Identifier: Apache-2.0
// What each kind of block computes, written by hand as a designer would; see composition.sh. Nothing here is shared with the
// SystemC model but the names of the ports, and those of registers that are no output.
//   A, B, D, P, Q, S, Y   bits of the port with this letter
//   AS, BS, ...           1 if the port carries two's complement
//   AU, BU, U             places by which an operand moves up, so that the binary points meet
//   DROP                  fraction bits that are rounded off: to nearest, ties up
// A result keeps its lowest bits. That no legal input needs more is asserted elsewhere, by no_overflow() of the formats.
`default_nettype none
/* verilator lint_off WIDTH */  // written as formulas are: Verilog's own extension of operands is meant
/* verilator lint_off DECLFILENAME */

// Registers.

module register #(
    parameter D = 1
) (
    input wire clk, rst_n,
    input wire [D-1:0] d_i,
    input wire we_i,
    output reg [D-1:0] q_o
);
  always @(posedge clk)
    if (!rst_n) q_o <= 0;
    else if (we_i) q_o <= d_i;
endmodule

// Takes d_i where a strobe has ended.
module register_trailing #(
    parameter D = 1
) (
    input wire clk, rst_n,
    input wire [D-1:0] d_i,
    input wire we_i,
    output reg [D-1:0] q_o
);
  reg we_q;
  always @(posedge clk)
    if (!rst_n) begin
      we_q <= 0;
      q_o <= 0;
    end else begin
      we_q <= we_i;
      if (we_q & ~we_i) q_o <= d_i;
    end
endmodule

// Arithmetic.

module wired #(
    parameter Y = 1,
    parameter [Y-1:0] VALUE = 0
) (
    output wire [Y-1:0] y_o
);
  assign y_o = VALUE;
endmodule

// The same bits; with another binary point, or with more of them on either side.
module wires #(
    parameter A = 1, U = 0, Y = A
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire [Y-1:0] wide = a_i;
  assign y_o = wide << U;
endmodule

module multiplier #(
    parameter A = 1, AS = 0, B = 1, BS = 0, P = 1, DROP = 0
) (
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    output wire [P-1:0] p_o
);
  wire [A+B+1:0] exact;
  generate
    if (AS && BS)  assign exact = $signed(a_i) * $signed(b_i);
    else if (AS)   assign exact = $signed(a_i) * $signed({1'b0, b_i});
    else if (BS)   assign exact = $signed({1'b0, a_i}) * $signed(b_i);
    else           assign exact = a_i * b_i;
  endgenerate
  wire [A+B+1:0] half = DROP == 0 ? 0 : 1 << (DROP - 1);
  assign p_o = (exact + half) >> DROP;
endmodule

module adder #(
    parameter A = 1, AS = 0, AU = 0, B = 1, BS = 0, BU = 0, S = 1
) (
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    input wire carry_i,
    output wire [S-1:0] s_o
);
  wire [A+S:0] a = {{S + 1{AS != 0 & a_i[A-1]}}, a_i};
  wire [B+S:0] b = {{S + 1{BS != 0 & b_i[B-1]}}, b_i};
  assign s_o = (a << AU) + (b << BU) + carry_i;
endmodule

module inverters #(
    parameter A = 1, U = 0, Y = 1
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire [Y-1:0] wide = a_i;
  assign y_o = ~(wide << U);
endmodule

// Rounds, and limits to 0..MOST.
module rounding #(
    parameter A = 1, AS = 0, DROP = 0, Y = 1,
    parameter [Y-1:0] MOST = {Y{1'b1}}
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire signed [A+Y+1:0] wide = {{Y + 2{AS != 0 & a_i[A-1]}}, a_i};
  wire signed [A+Y+1:0] half = DROP == 0 ? 0 : 1 << (DROP - 1);
  wire signed [A+Y+1:0] rounded = (wide + half) >>> DROP;
  assign y_o = rounded < 0 ? 0 : rounded > $signed({1'b0, MOST}) ? MOST : rounded;
endmodule

// y_o = 1 where a_i < 0.
module sign #(
    parameter A = 1
) (
    input wire [A-1:0] a_i,
    output wire y_o
);
  assign y_o = a_i[A-1];
endmodule

// y_o = a_i, and 0 where off_i is 1.
module gate #(
    parameter A = 1
) (
    input wire [A-1:0] a_i,
    input wire off_i,
    output wire [A-1:0] y_o
);
  assign y_o = a_i & {A{~off_i}};
endmodule

// 2^U - a_i.
module one_minus #(
    parameter A = 1, U = A - 1
) (
    input wire [A-1:0] a_i,
    output wire [A-1:0] y_o
);
  assign y_o = (1 << U) - a_i;
endmodule

// composition.sh cuts a memory out on both sides: its address is compared, its word is any. The words themselves are what
// tests of the device's contents look at. What stands here is no formula: an empty module would have no parameters.
module memory #(
    parameter A = 1, Y = 1
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  assign y_o = {Y{^a_i}};
endmodule

`default_nettype wire
