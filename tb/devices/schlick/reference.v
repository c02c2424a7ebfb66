// SPDX-License-Identifier: Apache-2.0
// Schlick's lobe as a designer would write it by hand, in one module; c is cos(delta):
//   brdf = c / (n (1 - c) + c),   colours = brdf * (R, G, B) k_s
// It shares nothing with the SystemC model but the ports, the names of the registers and the meaning of the formats: c has
// F fraction bits and is legal up to 2^F, the BRDF is rounded to F fraction bits, to nearest, ties up. Without an exponent
// and a cosine, after a reset, the quotient has all bits at one, as that of a divider has.
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

  // Registers. Register 2 loads on the trailing edge of its strobe.
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

  wire [F:0]     below_1 = (1 << F) - cos_delta;
  wire [F+10:0]  divisor = n * below_1 + cos_delta;
  wire [2*F+1:0] moved = {cos_delta, {F + 1{1'b0}}};
  wire [F+1:0]   quotient = divisor == 0 ? {F + 2{1'b1}} : moved / divisor;
  wire [F:0]     brdf = (quotient + 1) >> 1;

  assign r_o = brdf * r_ks;
  assign g_o = brdf * g_ks;
  assign b_o = brdf * b_ks;
  assign valid_o = cos_we_i;

endmodule

`default_nettype wire
