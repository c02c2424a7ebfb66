// SPDX-License-Identifier: Apache-2.0
// cos^n by its logarithm, c = 2^-(z + 1) (1 + f), x = -n log2 c, brdf = 2^-x: widths, nets, and the blocks up to where a
// pipeline has its first registers. Of c, F fraction bits.

  // The segments of f are 2^-I long, those of the fraction of x 2^-J. Fraction bits of the memories' words, of what is
  // cut from the lines, of the logarithm, and of what is kept of x; bits of the count of zeros and of a shift.
  localparam I = F / 2 - 2;
  localparam J = F / 2 - 1;
  localparam W = F + 4;
  localparam V = F + 3;
  localparam K = 2 * F + 1 < F + 12 ? 2 * F + 1 : F + 12;
  localparam P = F + 3;
  localparam Z = $clog2(F);
  localparam S = $clog2(F + 3);
  // Places of 1 + f and of x below a segment; bits of a change: no line falls by 2^-(I + 1) or 2^-J.
  localparam PI = F - 1 - I;
  localparam PJ = P - J;
  localparam CI = W - I;
  localparam CJ = W - J + 1;

  wire [1:0] two;
  wire one, zero, is_zero, is_off;
  wire [F:0] mantissa, rounded;
  wire [Z-1:0] zeros;
  wire [F+1:0] minus_mantissa;
  wire [F-1:0] distance;
  wire [I-1:0] ratio_segment;
  wire [PI-1:0] ratio_place;
  wire [W:0] ratio_begin, power_begin;
  wire [CI-1:0] ratio_change;
  wire [CI+PI-1:0] ratio_product;
  wire [W+PI:0] ratio_line;
  wire [V:0] ratio, power, shifted;
  wire [F+V:0] log_product;
  wire [K:0] log_fraction;
  wire [Z+K-1:0] log;
  wire [Z+K+9:0] x;
  wire [Z+9-S:0] above;
  wire [S-1:0] places;
  wire [J-1:0] power_segment;
  wire [PJ-1:0] power_place;
  wire [CJ-1:0] power_change;
  wire [CJ+PJ-1:0] power_product;
  wire [W+PJ:0] power_line;

  wired #(.Y(2), .VALUE(2)) node2 (.y_o(two));
  wired #(.VALUE(1)) carry_f (.y_o(one));
  wired #(.VALUE(0)) ground (.y_o(zero));

  // -log2 c = z + (1 - f) r(f)
  normaliser #(.F(F), .Z(Z)) norm (.a_i(c), .m_o(mantissa), .zeros_o(zeros), .zero_o(is_zero));
  inverters #(.A(F + 1), .Y(F + 2)) inv_f (.a_i(mantissa), .y_o(minus_mantissa));
  adder #(.A(2), .AU(F - 1), .B(F + 2), .BS(1), .S(F)) add_f
      (.a_i(two), .b_i(minus_mantissa), .carry_i(one), .s_o(distance));
  field #(.A(F + 1), .LOW(PI), .Y(I)) index_ratio (.a_i(mantissa), .y_o(ratio_segment));
  field #(.A(F + 1), .Y(PI)) place_ratio (.a_i(mantissa), .y_o(ratio_place));
  memory #(.A(I), .Y(W + 1)) rom_ratio (.a_i(ratio_segment), .y_o(ratio_begin));
  memory #(.A(I), .Y(CI)) rom_ratio_change (.a_i(ratio_segment), .y_o(ratio_change));
