// SPDX-License-Identifier: Apache-2.0
// UA 71489 as [P] describes it: out = intensity cos^k(factor[n] |angle|), the angle running along a scan line; see
// tb/cosim/composition. F fraction bits of the reflectance, F + 10 of angles; Q and k as preset. ENERGY: with a factor of the
// lobe.
`default_nettype none
`ifdef ENERGY
`define BRDF F + 9
`define OUT F + 17
`else
`define BRDF F + 1
`define OUT F + 8
`endif

module composed #(
    parameter F = 8
) (
    input wire clk, rst_n,
    input wire [9:0] n_i,
    input wire [7:0] intensity_i,
    input wire [F+10:0] angle_i,
    input wire [F+7:0] step_i,
    input wire [9:0] count_i,
    input wire start_i,
    output wire ready_o,
    output wire [`OUT-1:0] out_o,
    output wire valid_o
);

  // Address bits of a part of ROM 1.
  localparam A = F < 9 ? F + 1 : 10;

  wire load, first, advance, last, zero;
  wire [7:0] intensity;
  wire [F+7:0] step;
  wire [F+10:0] start_angle;
  wire [F+18:0] sum, next_angle, current_angle;
  wire [9:0] n;
  wire [F+17:0] distance;
  wire [A+6:0] limited;
  wire [A+8:0] factor;
  wire [2*A+15:0] turned;
  wire [A:0] place;
  wire [3:0] part;
  wire [F:0] lobe;
  wire [`BRDF-1:0] brdf;

  scan_control control (.clk(clk), .rst_n(rst_n), .start_i(start_i), .carry_i(last),
      .load_o(load), .first_o(first), .step_o(advance), .draw_o(valid_o), .ready_o(ready_o));
  down_counter #(.D(10)) cnt
      (.clk(clk), .rst_n(rst_n), .load_i(load), .count_i(valid_o), .d_i(count_i), .carry_o(last));
  register #(.D(8)) rg1 (.clk(clk), .rst_n(rst_n), .d_i(intensity_i), .we_i(load), .q_o(intensity));
  register #(.D(F + 8)) rg2 (.clk(clk), .rst_n(rst_n), .d_i(step_i), .we_i(load), .q_o(step));
  register #(.D(F + 11)) rg3 (.clk(clk), .rst_n(rst_n), .d_i(angle_i), .we_i(load), .q_o(start_angle));
  register #(.D(F + 19)) rg4 (.clk(clk), .rst_n(rst_n), .d_i(next_angle), .we_i(advance), .q_o(current_angle));
  register #(.D(10)) rg5 (.clk(clk), .rst_n(rst_n), .d_i(n_i), .we_i(load), .q_o(n));
  wired #(.VALUE(0)) ground (.y_o(zero));
  adder #(.A(F + 19), .AS(1), .B(F + 8), .BS(1), .S(F + 19)) add4
      (.a_i(current_angle), .b_i(step), .carry_i(zero), .s_o(sum));
  multiplexer #(.A(F + 19), .B(F + 11)) mux (.a_i(sum), .b_i(start_angle), .select_b_i(first), .y_o(next_angle));
  magnitude #(.A(F + 19)) mag4 (.a_i(current_angle), .y_o(distance));
  rounding #(.A(F + 18), .DROP(F + 4 - A), .Y(A + 7)) limit4 (.a_i(distance), .y_o(limited));
  memory #(.A(10), .Y(A + 9)) rom2 (.a_i(n), .y_o(factor));
  multiplier #(.A(A + 7), .B(A + 9), .P(2 * A + 16)) mul2 (.a_i(limited), .b_i(factor), .p_o(turned));
  rounding #(.A(2 * A + 16), .DROP(A + 10), .Y(A + 1), .MOST(1 << A)) quant2 (.a_i(turned), .y_o(place));
  part_decoder #(.FIRST(5), .A(10), .Y(4)) dec (.n_i(n), .part_o(part));
  parted_memory #(.P(4), .A(A + 1), .Y(F + 1)) rom1 (.part_i(part), .a_i(place), .y_o(lobe));
`ifdef ENERGY
  wire [A+14:0] energy;
  memory #(.A(10), .Y(A + 15)) rom_energy (.a_i(n), .y_o(energy));
  multiplier #(.A(F + 1), .B(A + 15), .P(`BRDF), .DROP(A + 6)) mul_energy (.a_i(lobe), .b_i(energy), .p_o(brdf));
`else
  assign brdf = lobe;
`endif
  multiplier #(.A(`BRDF), .B(8), .P(`OUT)) mul1 (.a_i(brdf), .b_i(intensity), .p_o(out_o));

endmodule

`default_nettype wire
