// SPDX-License-Identifier: Apache-2.0
// [P] fig. 1 with registers at four cuts, block for block; see tb/devices/quadratic/composed.v and tb/cosim/composition.
`include "pipelined.vh"

  // Fraction bits of a and of c^2; S = 2 (1 - e^(-1/2)), rounded from 40 bits.
  localparam K = F < 20 ? F : 20;
  localparam D = F < 12 ? 2 * F : F < 23 ? F + 12 : 35;
  localparam [39:0] S40 = 40'd865248229639;
  localparam [K-1:0] S = (S40 + (40'd1 << (39 - K))) >> (40 - K);

  wire one, zero;
  wire [F:0] c_1, c_3, limited;
  wire [D:0] c2, c2_1;
  wire [D+1:0] minus_c;
  wire [D-2:0] c2_c, c2_c_2;
  wire [K-1:0] s;
  wire [1:0] minus_half;
  wire [K+9:0] s_n, s_n_1, a, a_2;
  wire [K+D+8:0] a_c2_c, a_c2_c_3, parabola;

  wired #(.VALUE(1)) carry28 (.y_o(one));
  wired #(.VALUE(0)) carry30 (.y_o(zero));
  multiplier #(.A(F + 1), .B(F + 1), .P(D + 1), .DROP(2 * F - D)) mul7 (.a_i(c), .b_i(c), .p_o(c2));
  wired #(.Y(K), .VALUE(S)) node31 (.y_o(s));
  multiplier #(.A(10), .B(K), .P(K + 10)) mul6 (.a_i(n), .b_i(s), .p_o(s_n));

  // Cut 1.
  pipe #(.D(D + 1)) pipe_cos2 (.clk(clk), .rst_n(rst_n), .go_i(go), .d_i(c2), .q_o(c2_1));
  wired #(.Y(2), .VALUE(2'b11)) node32 (.y_o(minus_half));
