// SPDX-License-Identifier: Apache-2.0
// The lighting unit, without energy factor, as a designer would write it by hand from the formulas:
//   sum = min(255, (first ? I_a k_a : sum) + I_l k_d N.L + S) for each channel,   colour = sum rounded to nearest, ties up
// It shares nothing with the SystemC model but the ports and the meaning of the formats: N.L and the specular terms S have F
// fraction bits, 8 and up, coefficients have 8, terms and sums 16, to nearest, ties up, and 24 wires.
`default_nettype none
/* verilator lint_off WIDTH */  // written as formulas are: Verilog's own extension of operands is meant

module reference #(
    parameter F = 8
) (
    input  wire         clk,
    input  wire         rst_n,
    input  wire [F:0]   nl_i,
    input  wire         first_i,
    input  wire [15:0]  ar_i,
    input  wire [15:0]  ag_i,
    input  wire [15:0]  ab_i,
    input  wire [15:0]  dr_i,
    input  wire [15:0]  dg_i,
    input  wire [15:0]  db_i,
    input  wire [F+7:0] sr_i,
    input  wire [F+7:0] sg_i,
    input  wire [F+7:0] sb_i,
    input  wire         start_i,
    input  wire         stall_i,
    output wire         ready_o,
    output reg  [23:0]  r_sum_o,
    output reg  [23:0]  g_sum_o,
    output reg  [23:0]  b_sum_o,
    output wire [7:0]   r_o,
    output wire [7:0]   g_o,
    output wire [7:0]   b_o,
    output reg          valid_o
);

  localparam [25:0] MOST = 255 << 16;

  // I_l k_d N.L, without the F - 8 bits below those of a sum.
  function [23:0] diffuse(input [15:0] coefficient, input [F:0] cosine);
    reg [F+16:0] product;
    begin
      product = coefficient * cosine;
      diffuse = (product + (1 << (F - 8) >> 1)) >> (F - 8);
    end
  endfunction

  // A specular term with 16 fraction bits.
  function [23:0] specular(input [F+7:0] term);
    reg [48:0] wide;
    begin
      wide = term << 16;  // F + 16 fraction bits
      specular = (wide + (1 << (F - 1))) >> F;
    end
  endfunction

  // What the sum becomes.
  function [23:0] added(input [23:0] sum, input [15:0] ambient, input [23:0] diffuse_term, input [23:0] specular_term);
    reg [25:0] total;
    begin
      total = (first_i ? ambient << 8 : sum) + diffuse_term + specular_term;
      added = total > MOST ? MOST : total;
    end
  endfunction

  assign ready_o = !(valid_o && stall_i);

  wire [23:0] red_diffuse = diffuse(dr_i, nl_i), green_diffuse = diffuse(dg_i, nl_i), blue_diffuse = diffuse(db_i, nl_i);
  wire [23:0] red_specular = specular(sr_i), green_specular = specular(sg_i), blue_specular = specular(sb_i);

  always @(posedge clk)
    if (!rst_n) begin
      valid_o <= 0;
      r_sum_o <= 0;
      g_sum_o <= 0;
      b_sum_o <= 0;
    end else if (ready_o) begin
      valid_o <= start_i;
      if (start_i) begin
        r_sum_o <= added(r_sum_o, ar_i, red_diffuse, red_specular);
        g_sum_o <= added(g_sum_o, ag_i, green_diffuse, green_specular);
        b_sum_o <= added(b_sum_o, ab_i, blue_diffuse, blue_specular);
      end
    end

  // At most 255, so that the sum of the half stays within 24 bits.
  wire [23:0] red = r_sum_o + 24'h8000, green = g_sum_o + 24'h8000, blue = b_sum_o + 24'h8000;
  assign r_o = red[23:16];
  assign g_o = green[23:16];
  assign b_o = blue[23:16];

endmodule

`default_nettype wire
