// SPDX-License-Identifier: Apache-2.0
// The device of [T] fig. 3.1 as a designer would write it by hand from the formulas, in one module; c is cos(gamma):
//   brdf = (1 - m (1 - c))^2, 0 where the bracket is negative,   m = (n + 1)/3,   colours = brdf * (R, G, B) k_s
// It shares nothing with the SystemC model but the ports, the names of the registers and the meaning of the formats: c has
// F fraction bits and is legal up to 2^F, m is rounded to F fraction bits, the bracket to F + 3, the BRDF to F, each to
// nearest, ties up. m is found by a division where the device has a memory.
`default_nettype none
/* verilator lint_off WIDTH */  // written as formulas are: Verilog's own extension of operands is meant

module reference #(
    parameter F = 8
) (
    input  wire         clk,
    input  wire         rst_n,
    input  wire [9:0]   n_i,
    input  wire         n_we_i,
    input  wire [F:0]   cos_i,
    input  wire         cos_we_i,
    input  wire [7:0]   r_i,
    input  wire         r_we_i,
    input  wire [7:0]   g_i,
    input  wire         g_we_i,
    input  wire [7:0]   b_i,
    input  wire         b_we_i,
    output wire [F+7:0] r_o,
    output wire [F+7:0] g_o,
    output wire [F+7:0] b_o,
    output wire         valid_o
);

  localparam T = F + 3;  // fraction bits of the bracket where it is squared

  // Registers. That of the cosine loads on the trailing edge of its strobe.
  reg [9:0] n;
  reg [F:0] cos_delta;
  reg [7:0] r_ks, g_ks, b_ks;
  reg       strobe17;

  always @(posedge clk)
    if (!rst_n) begin
      n <= 0;
      cos_delta <= 0;
      r_ks <= 0;
      g_ks <= 0;
      b_ks <= 0;
      strobe17 <= 0;
    end else begin
      strobe17 <= cos_we_i;
      if (n_we_i) n <= n_i;
      if (strobe17 & ~cos_we_i) cos_delta <= cos_i;
      if (r_we_i) r_ks <= r_i;
      if (g_we_i) g_ks <= g_i;
      if (b_we_i) b_ks <= b_i;
    end

  // m has F fraction bits: (n + 1) 2^F / 3 + 1/2, rounded down.
  wire [10:0]   n_plus_1 = n + 1;
  wire [F+11:0] doubled = {n_plus_1, {F + 1{1'b0}}} + 3;
  wire [F+8:0]  m = doubled / 6;

  // How far the bracket is below 1, with 2F fraction bits.
  wire [F:0]     below_1 = (1 << F) - cos_delta;
  wire [2*F+9:0] fall = m * below_1;
  wire           is_beyond_root = fall > {1'b1, {2 * F{1'b0}}};

  // The bracket, in [0, 1] up to the root, and its square.
  wire [2*F:0]   bracket = {1'b1, {2 * F{1'b0}}} - fall;
  wire [T:0]     rounded = (bracket + (1 << (2 * F - T - 1))) >> (2 * F - T);
  wire [2*T+1:0] square = rounded * rounded;
  wire [F:0]     brdf = is_beyond_root ? 0 : (square + (1 << (2 * T - F - 1))) >> (2 * T - F);

  assign r_o = brdf * r_ks;
  assign g_o = brdf * g_ks;
  assign b_o = brdf * b_ks;
  assign valid_o = cos_we_i;

endmodule

`default_nettype wire
