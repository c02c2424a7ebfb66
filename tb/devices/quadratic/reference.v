// SPDX-License-Identifier: Apache-2.0
// The device of [P] fig. 1 as a designer would write it by hand from the formulas, in one module; c is cos(delta):
//   brdf = a (c^2 - c) + c clamped to [0, 1],   a = S n - 1/2,   colours = brdf * (R, G, B) k_s
// It shares nothing with the SystemC model but the ports, the names of the registers and the meaning of the formats: c has
// F fraction bits and is legal up to 2^F, the constant S = 2(1 - e^(-1/2)) is rounded to K bits, c^2 has D fraction bits,
// rounded to nearest (exact if D = 2 F), and the BRDF is rounded to F fraction bits, to nearest, ties up.
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

  localparam K = F < 20 ? F : 20;
  localparam D = F < 12 ? 2 * F : F < 23 ? F + 12 : 35;
  localparam [39:0] S40 = 40'd865248229639;  // S of 40 bits
  localparam [K-1:0] S = (S40 + (40'd1 << (39 - K))) >> (40 - K);

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

  // a has K fraction bits.
  wire [K+9:0] a = n * S - (1 << (K - 1));

  // c - c^2, which lies in [0, 1/4], with D fraction bits.
  wire [2*F+1:0] c2 = cos_delta * cos_delta;
  wire [D:0]     c2_rounded;
  wire [D:0]     c_minus_c2 = (cos_delta << (D - F)) - c2_rounded;
  generate
    if (D == 2 * F) assign c2_rounded = c2[D:0];
    else            assign c2_rounded = (c2 + (1 << (2 * F - D - 1))) >> (2 * F - D);
  endgenerate

  // The parabola with K + D fraction bits: at most 1, at least -(2^10) / 4.
  wire signed [K+D+9:0] parabola = (cos_delta << (K + D - F)) - a * c_minus_c2[D-2:0];
  wire signed [F+9:0]   rounded = (parabola + (1 << (K + D - F - 1))) >>> (K + D - F);

  wire [F:0] brdf = rounded < 0 ? 0 : rounded > (1 << F) ? 1 << F : rounded;

  assign r_o = brdf * r_ks;
  assign g_o = brdf * g_ks;
  assign b_o = brdf * b_ks;
  assign valid_o = cos_we_i;

endmodule

`default_nettype wire
