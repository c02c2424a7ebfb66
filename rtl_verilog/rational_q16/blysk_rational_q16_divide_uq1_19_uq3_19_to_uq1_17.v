// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device rational, format q16, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q16_divide_uq1_19_uq3_19_to_uq1_17 (
    input  wire [19:0] a_i,  // UQ1.19, codes 0..524288
    input  wire [21:0] b_i,  // UQ3.19
    output wire [17:0] q_o  // UQ1.17, codes 0..131072
);

  wire flag = {2'b0, a_i} < b_i;
  wire [22:0] shifted = {(flag ? {2'b0, a_i} : {2'b0, a_i} - b_i) & 22'd4194303, 1'b0};
  wire flag2 = shifted < {1'b0, b_i};
  wire [22:0] shifted2 = {(flag2 ? shifted[21:0] : shifted[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag3 = shifted2 < {1'b0, b_i};
  wire [22:0] shifted3 = {(flag3 ? shifted2[21:0] : shifted2[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag4 = shifted3 < {1'b0, b_i};
  wire [22:0] shifted4 = {(flag4 ? shifted3[21:0] : shifted3[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag5 = shifted4 < {1'b0, b_i};
  wire [22:0] shifted5 = {(flag5 ? shifted4[21:0] : shifted4[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag6 = shifted5 < {1'b0, b_i};
  wire [22:0] shifted6 = {(flag6 ? shifted5[21:0] : shifted5[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag7 = shifted6 < {1'b0, b_i};
  wire [22:0] shifted7 = {(flag7 ? shifted6[21:0] : shifted6[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag8 = shifted7 < {1'b0, b_i};
  wire [22:0] shifted8 = {(flag8 ? shifted7[21:0] : shifted7[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag9 = shifted8 < {1'b0, b_i};
  wire [22:0] shifted9 = {(flag9 ? shifted8[21:0] : shifted8[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag10 = shifted9 < {1'b0, b_i};
  wire [22:0] shifted10 = {(flag10 ? shifted9[21:0] : shifted9[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag11 = shifted10 < {1'b0, b_i};
  wire [22:0] shifted11 = {(flag11 ? shifted10[21:0] : shifted10[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag12 = shifted11 < {1'b0, b_i};
  wire [22:0] shifted12 = {(flag12 ? shifted11[21:0] : shifted11[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag13 = shifted12 < {1'b0, b_i};
  wire [22:0] shifted13 = {(flag13 ? shifted12[21:0] : shifted12[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag14 = shifted13 < {1'b0, b_i};
  wire [22:0] shifted14 = {(flag14 ? shifted13[21:0] : shifted13[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag15 = shifted14 < {1'b0, b_i};
  wire [22:0] shifted15 = {(flag15 ? shifted14[21:0] : shifted14[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag16 = shifted15 < {1'b0, b_i};
  wire [22:0] shifted16 = {(flag16 ? shifted15[21:0] : shifted15[21:0] - b_i) & 22'd4194303, 1'b0};
  wire flag17 = shifted16 < {1'b0, b_i};

  assign q_o = (((((((((((((((({flag == 1'd0, 17'b0} | {1'b0, flag2 == 1'd0, 16'b0}) | {2'b0, flag3 == 1'd0, 15'b0}) | {3'b0, flag4 == 1'd0, 14'b0}) | {4'b0, flag5 == 1'd0, 13'b0}) | {5'b0, flag6 == 1'd0, 12'b0}) | {6'b0, flag7 == 1'd0, 11'b0}) | {7'b0, flag8 == 1'd0, 10'b0}) | {8'b0, flag9 == 1'd0, 9'b0}) | {9'b0, flag10 == 1'd0, 8'b0}) | {10'b0, flag11 == 1'd0, 7'b0}) | {11'b0, flag12 == 1'd0, 6'b0}) | {12'b0, flag13 == 1'd0, 5'b0}) | {13'b0, flag14 == 1'd0, 4'b0}) | {14'b0, flag15 == 1'd0, 3'b0}) | {15'b0, flag16 == 1'd0, 2'b0}) | {16'b0, flag17 == 1'd0, 1'b0}) | {17'b0, ({(flag17 ? shifted16[21:0] : shifted16[21:0] - b_i) & 22'd4194303, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
