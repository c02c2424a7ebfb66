// SPDX-License-Identifier: Apache-2.0
// As formulas.v, of the blocks of devices that take several clock cycles; see composition.sh. Registers of a block are
// called as those of the export, so that they are compared.
//   D, DU   bits of d_i, places by which it moves up
//   DS      1 if d_i carries two's complement
`default_nettype none
/* verilator lint_off WIDTH */  // written as formulas are: Verilog's own extension of operands is meant
/* verilator lint_off DECLFILENAME */

// Controls.

// After a start, STEPS cycles with step_o; then one with done_o.
module sequencer #(
    parameter STEPS = 1
) (
    input wire clk, rst_n,
    input wire start_i,
    output wire load_o, step_o, ready_o,
    output reg done_o
);
  reg [6:0] left;
  assign ready_o = left == 0;
  assign step_o = left > 0;
  assign load_o = start_i & ready_o;
  always @(posedge clk)
    if (!rst_n) begin
      left <= 0;
      done_o <= 0;
    end else begin
      if (load_o) left <= STEPS;
      else if (step_o) left <= left - 1;
      done_o <= left == 1;
    end
endmodule

// After a start, DIGITS cycles with step_o, the first of them with first_o too; then one with done_o.
module digit_control #(
    parameter DIGITS = 1
) (
    input wire clk, rst_n,
    input wire start_i,
    output wire take_o, first_o, step_o, ready_o,
    output reg done_o
);
  reg [6:0] left;
  assign ready_o = left == 0;
  assign step_o = left > 0;
  assign first_o = left == DIGITS;
  assign take_o = start_i & ready_o;
  always @(posedge clk)
    if (!rst_n) begin
      left <= 0;
      done_o <= 0;
    end else begin
      if (take_o) left <= DIGITS;
      else if (step_o) left <= left - 1;
      done_o <= left == 1;
    end
endmodule

// After a start, length_i + 1 cycles with draw_o.
module pixel_counter #(
    parameter D = 1
) (
    input wire clk, rst_n,
    input wire start_i,
    input wire [D-1:0] length_i,
    output wire load_o, draw_o, ready_o
);
  reg [D:0] left;
  assign ready_o = left == 0;
  assign draw_o = left > 0;
  assign load_o = start_i & ready_o;
  always @(posedge clk)
    if (!rst_n) left <= 0;
    else if (load_o) left <= length_i + 1;
    else if (draw_o) left <= left - 1;
endmodule

// After a start, STEPS cycles with step_o; then length_i + 1 cycles with draw_o.
module line_control #(
    parameter STEPS = 1, D = 1
) (
    input wire clk, rst_n,
    input wire start_i,
    input wire [D-1:0] length_i,
    output wire load_o, step_o, draw_o, ready_o
);
  reg [6:0] steps_left;
  reg [D:0] pixels_left;
  assign ready_o = pixels_left == 0;
  assign step_o = steps_left > 0;
  assign draw_o = ~step_o & ~ready_o;
  assign load_o = start_i & ready_o;
  always @(posedge clk)
    if (!rst_n) begin
      steps_left <= 0;
      pixels_left <= 0;
    end else if (load_o) begin
      steps_left <= STEPS;
      pixels_left <= length_i + 1;
    end else begin
      if (step_o) steps_left <= steps_left - 1;
      if (draw_o) pixels_left <= pixels_left - 1;
    end
endmodule

// After a start, one cycle with first_o; then cycles with draw_o, the last of which sees carry_i.
module scan_control (
    input wire clk, rst_n,
    input wire start_i, carry_i,
    output wire load_o, first_o, step_o, draw_o, ready_o
);
  localparam [1:0] IDLE = 0, FIRST = 1, DRAW = 2;
  reg [1:0] now;
  assign ready_o = now == IDLE;
  assign first_o = now == FIRST;
  assign draw_o = now == DRAW;
  assign step_o = first_o | draw_o;
  assign load_o = start_i & ready_o;
  always @(posedge clk)
    if (!rst_n) now <= IDLE;
    else
      case (now)
        IDLE: if (start_i) now <= FIRST;
        FIRST: now <= DRAW;
        DRAW: if (carry_i) now <= IDLE;
        default: now <= IDLE;
      endcase
endmodule

// Pixels that are left; carry_o at the last one, and at none.
module down_counter #(
    parameter D = 1
) (
    input wire clk, rst_n,
    input wire load_i, count_i,
    input wire [D-1:0] d_i,
    output wire carry_o
);
  reg [D-1:0] left;
  assign carry_o = left <= 1;
  always @(posedge clk)
    if (!rst_n) left <= 0;
    else if (load_i) left <= d_i;
    else if (count_i & left > 0) left <= left - 1;
endmodule

// Registers.

// d_i / 2, then half of it with each step, rounded down; both of two's complement.
module shift_register #(
    parameter D = 1, DU = 1, Q = 1
) (
    input wire clk, rst_n,
    input wire load_i, step_i,
    input wire [D-1:0] d_i,
    output wire [Q-1:0] q_o
);
  reg signed [Q-1:0] held;
  wire signed [Q:0] wide = {{Q + 1{d_i[D-1]}}, d_i} << DU;
  assign q_o = held;
  always @(posedge clk)
    if (!rst_n) held <= 0;
    else if (load_i) held <= wide >>> 1;
    else if (step_i) held <= held >>> 1;
endmodule

// The digits of d_i one after the other, the first while load_i is one.
module digit_register #(
    parameter D = 1
) (
    input wire clk, rst_n,
    input wire load_i, step_i,
    input wire [D-1:0] d_i,
    output wire digit_o
);
  reg [D-1:0] held;
  wire [D-1:0] now = load_i ? d_i : held;
  assign digit_o = now[D-1];
  always @(posedge clk)
    if (!rst_n) held <= 0;
    else if (load_i | step_i) held <= now << 1;
endmodule

// Of an accumulating adder: adds d_i to 0, then sum_i, the adder's; where add_i is one.
module sum_register #(
    parameter D = 1, DU = 0, Q = 1
) (
    input wire clk, rst_n,
    input wire load_i, step_i, add_i,
    input wire [D-1:0] d_i,
    input wire [Q-1:0] sum_i,
    output reg [Q-1:0] q_o
);
  wire [Q-1:0] wide = {{Q{d_i[D-1]}}, d_i};
  always @(posedge clk)
    if (!rst_n) q_o <= 0;
    else if (load_i & add_i) q_o <= wide << DU;
    else if (load_i) q_o <= 0;
    else if (step_i & add_i) q_o <= sum_i;
endmodule

// Of an interpolator: d_i, then sum_i with each step.
module start_register #(
    parameter D = 1, DS = 0, DU = 0, Q = 1
) (
    input wire clk, rst_n,
    input wire load_i, step_i,
    input wire [D-1:0] d_i,
    input wire [Q-1:0] sum_i,
    output reg [Q-1:0] q_o
);
  wire [Q-1:0] wide = {{Q{DS != 0 & d_i[D-1]}}, d_i};
  always @(posedge clk)
    if (!rst_n) q_o <= 0;
    else if (load_i) q_o <= wide << DU;
    else if (step_i) q_o <= sum_i;
endmodule

// Operations of a digit a cycle. What stands here is the division, and the root, as done by hand. That digits found so
// are the quotient, and the root, is not proved here: tests of the blocks compare them with integers.

// The first digit comes with the load. The dividend moves up by AU, the divisor by BU.
module divide_steps #(
    parameter A = 1, AU = 0, B = 1, BU = 0, Q = 2
) (
    input wire clk, rst_n,
    input wire load_i, step_i,
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    output wire [Q-1:0] q_o
);
  reg [Q-1:0] digits;
  reg [B+BU-1:0] divisor;
  reg [B+BU:0] rest;
  wire [B+BU-1:0] aligned = b_i;
  wire [B+BU-1:0] by = load_i ? aligned << BU : divisor;
  wire [B+BU:0] dividend = a_i;
  wire [B+BU:0] now = load_i ? dividend << AU : rest;
  wire goes_in = now >= by;
  assign q_o = digits;
  always @(posedge clk)
    if (!rst_n) begin
      digits <= 0;
      divisor <= 0;
      rest <= 0;
    end else if (load_i | step_i) begin
      digits <= {load_i ? {Q - 1{1'b0}} : digits[Q-2:0], goes_in};
      divisor <= by;
      rest <= (goes_in ? now - by : now) << 1;
    end
endmodule

// d_i has F fraction bits and one before the point, F even.
module square_root_steps #(
    parameter F = 2, Q = 1
) (
    input wire clk, rst_n,
    input wire load_i, step_i,
    input wire [F:0] d_i,
    output wire [Q-1:0] root_o
);
  reg [F+1:0] rest;  // of the radicand
  reg [Q:0] remainder;
  reg [Q-1:0] digits;
  wire [Q+2:0] now = {remainder, rest[F+1:F]};
  wire [Q+2:0] tried = {digits, 2'b01};
  wire goes_in = now >= tried;
  assign root_o = digits;
  always @(posedge clk)
    if (!rst_n) begin
      rest <= 0;
      remainder <= 0;
      digits <= 0;
    end else if (load_i) begin
      rest <= d_i;
      remainder <= 0;
      digits <= 0;
    end else if (step_i) begin
      rest <= rest << 2;
      remainder <= goes_in ? now - tried : now;
      digits <= {digits, goes_in};
    end
endmodule

// Arithmetic.

// |a_i|
module magnitude #(
    parameter A = 2
) (
    input wire [A-1:0] a_i,
    output wire [A-2:0] y_o
);
  assign y_o = a_i[A-1] ? -a_i : a_i;
endmodule

// y_o = a_i, and -a_i where negative_i is one.
module with_sign #(
    parameter A = 1, Y = 1
) (
    input wire [A-1:0] a_i,
    input wire negative_i,
    output wire [Y-1:0] y_o
);
  assign y_o = negative_i ? -a_i : a_i;
endmodule

// b_i, of no sign, where select_b_i is one; else a_i.
module multiplexer #(
    parameter A = 1, B = 1
) (
    input wire [A-1:0] a_i,
    input wire [B-1:0] b_i,
    input wire select_b_i,
    output wire [A-1:0] y_o
);
  assign y_o = select_b_i ? b_i : a_i;
endmodule

// The same number with TO fraction bits in the place of FROM: rounded where these are fewer.
module rescale #(
    parameter A = 1, FROM = 0, TO = 0, Y = 1
) (
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  wire [A+Y-1:0] wide = a_i;
  assign y_o = TO >= FROM ? wide << (TO - FROM) : (wide + (1 << (FROM - TO - 1))) >> (FROM - TO);
endmodule

// n_i below FIRST, 0 from there on.
module part_decoder #(
    parameter FIRST = 1, A = 1, Y = 1
) (
    input wire [A-1:0] n_i,
    output wire [Y-1:0] part_o
);
  assign part_o = n_i < FIRST ? n_i : 0;
endmodule

// As memory, in parts; both its addresses are compared.
module parted_memory #(
    parameter P = 1, A = 1, Y = 1
) (
    input wire [P-1:0] part_i,
    input wire [A-1:0] a_i,
    output wire [Y-1:0] y_o
);
  assign y_o = {Y{^{part_i, a_i}}};
endmodule

`default_nettype wire
