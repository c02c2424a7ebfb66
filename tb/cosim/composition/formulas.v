// SPDX-License-Identifier: Apache-2.0
// What each kind of block computes, written by hand as a designer would; see composition.sh. Nothing here is shared with the
// SystemC model but the names of the ports, and those of registers that are no output.
//   A, B, D, P, Q, S, Y   bits of the port with this letter
//   AS, BS, ...           1 if the port carries two's complement
//   AU, BU, CU, U         places by which an operand, or the carry, moves up, so that the binary points meet
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

// q_o is d_i, LENGTH clock edges with go_i later; 1 to 8.
module pipe #(
    parameter D = 1, LENGTH = 1
) (
    input wire clk, rst_n,
    input wire go_i,
    input wire [D-1:0] d_i,
    output reg [D-1:0] q_o
);
  reg [D-1:0] held_0, held_1, held_2, held_3, held_4, held_5, held_6;
  wire [8*D-1:0] moved = {held_6, held_5, held_4, held_3, held_2, held_1, held_0, d_i};
  always @(posedge clk)
    if (!rst_n) {held_6, held_5, held_4, held_3, held_2, held_1, held_0, q_o} <= 0;
    else if (go_i) begin
      {held_6, held_5, held_4, held_3, held_2, held_1, held_0} <= moved;
      q_o <= moved[(LENGTH-1)*D +: D];
    end
endmodule

// A pipeline goes on unless a result waits at its end.
module pipe_control (
    input wire start_i, stall_i, valid_i,
    output wire go_o, take_o, ready_o
);
  wire waits = valid_i & stall_i;
  assign go_o = ~waits;
  assign ready_o = ~waits;
  assign take_o = start_i & ~waits;
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
    parameter A = 1, AS = 0, AU = 0, B = 1, BS = 0, BU = 0, CU = 0, S = 1
) (
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    input wire carry_i,
    output wire [S-1:0] s_o
);
  wire [A+S:0] a = {{S + 1{AS != 0 & a_i[A-1]}}, a_i};
  wire [B+S:0] b = {{S + 1{BS != 0 & b_i[B-1]}}, b_i};
  wire [S-1:0] carry = carry_i;
  assign s_o = (a << AU) + (b << BU) + (carry << CU);
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

// Rounds.
module round_off #(
    parameter A = 1, DROP = 0, Y = 1
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire [A+Y:0] half = DROP == 0 ? 0 : 1 << (DROP - 1);
  assign y_o = (a_i + half) >> DROP;
endmodule

// Rounds, and limits to LEAST..MOST.
module rounding #(
    parameter A = 1, AS = 0, DROP = 0, Y = 1,
    parameter signed [Y:0] LEAST = 0, MOST = {1'b0, {Y{1'b1}}}
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire signed [A+Y+1:0] wide = {{Y + 2{AS != 0 & a_i[A-1]}}, a_i};
  wire signed [A+Y+1:0] half = DROP == 0 ? 0 : 1 << (DROP - 1);
  wire signed [A+Y+1:0] rounded = (wide + half) >>> DROP;
  assign y_o = rounded < LEAST ? LEAST : rounded > MOST ? MOST : rounded;
endmodule

// negative_o = 1 where a_i < 0.
module sign #(
    parameter A = 1
) (
    input wire [A-1:0] a_i,
    output wire negative_o
);
  assign negative_o = $signed(a_i) < 0;
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

// q_o = a_i / b_i for a_i <= b_i, rounded down, Q - 1 fraction bits: restoring division, which subtracts the divisor where
// the rest is not smaller, and doubles the rest for the next digit. The rest is doubled in as many bits as the divisor has
// and one more; it needs no others, for it is less than twice the divisor. See module division_step.
module divider #(
    parameter A = 1, AU = 0, B = 1, BU = 0, Q = 1
) (
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    output reg [Q-1:0] q_o
);
  localparam W = B + BU;
  wire [W-1:0] b = {{BU + 1{1'b0}}, b_i} << BU;
  reg [W:0] rest;
  reg is_smaller;
  integer i;
  always @* begin
    rest = a_i << AU;
    for (i = Q - 1; i >= 0; i = i - 1) begin
      is_smaller = rest < b;
      q_o[i] = ~is_smaller;
      rest = (is_smaller ? rest : rest - b) << 1;
    end
  end
endmodule

// a_i = m_o 2^-(zeros_o + 1) with m_o in [1, 2], for 0 < a_i <= 1: F fraction bits in a_i, F - 1 in m_o. For 0, m_o is 1 and
// zeros_o is all ones.
module normaliser #(
    parameter F = 1, Z = 1
) (
    input wire [F:0] a_i,
    output reg [F:0] m_o,
    output reg [Z-1:0] zeros_o,
    output wire zero_o
);
  assign zero_o = a_i == 0;
  integer i;
  always @* begin
    m_o = a_i;
    zeros_o = 0;
    for (i = 0; i < F - 1; i = i + 1)
      if (m_o < 1 << (F - 1)) begin
        m_o = m_o << 1;
        zeros_o = zeros_o + 1;
      end
    if (zero_o) begin
      m_o = 1 << (F - 1);
      zeros_o = ~0;
    end
  end
endmodule

module shifter #(
    parameter A = 1, PLACES = 1
) (
    input wire [A-1:0] a_i,
    input wire [PLACES-1:0] places_i,
    output wire [A-1:0] y_o
);
  assign y_o = a_i >> places_i;
endmodule

// Y bits of a_i, from bit LOW on.
module field #(
    parameter A = 1, LOW = 0, Y = 1
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  assign y_o = a_i >> LOW;
endmodule

// y_o = 1 where b_i, or any bit of a_i, is 1.
module any #(
    parameter A = 1
) (
    input wire [A-1:0] a_i,
    input wire b_i,
    output wire y_o
);
  assign y_o = a_i != 0 | b_i;
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
