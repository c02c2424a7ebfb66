// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device gx, format q24, a combinational divider, exported from the SystemC model.
`default_nettype none

module blysk_gx_q24_divide_uq1_36_uq9_37_to_uq1_25 (
    input  wire [36:0] a_i,  // UQ1.36, codes 0..68719476736
    input  wire [45:0] b_i,  // UQ9.37
    output wire [25:0] q_o  // UQ1.25, codes 0..33554432
);

  wire [37:0] shifted = {a_i, 1'b0};
  wire flag = {8'b0, shifted} < b_i;
  wire [46:0] shifted2 = {(flag ? {8'b0, shifted} : {8'b0, shifted} - b_i) & 46'd70368744177663, 1'b0};
  wire flag2 = shifted2 < {1'b0, b_i};
  wire [46:0] shifted3 = {(flag2 ? shifted2[45:0] : shifted2[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag3 = shifted3 < {1'b0, b_i};
  wire [46:0] shifted4 = {(flag3 ? shifted3[45:0] : shifted3[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag4 = shifted4 < {1'b0, b_i};
  wire [46:0] shifted5 = {(flag4 ? shifted4[45:0] : shifted4[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag5 = shifted5 < {1'b0, b_i};
  wire [46:0] shifted6 = {(flag5 ? shifted5[45:0] : shifted5[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag6 = shifted6 < {1'b0, b_i};
  wire [46:0] shifted7 = {(flag6 ? shifted6[45:0] : shifted6[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag7 = shifted7 < {1'b0, b_i};
  wire [46:0] shifted8 = {(flag7 ? shifted7[45:0] : shifted7[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag8 = shifted8 < {1'b0, b_i};
  wire [46:0] shifted9 = {(flag8 ? shifted8[45:0] : shifted8[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag9 = shifted9 < {1'b0, b_i};
  wire [46:0] shifted10 = {(flag9 ? shifted9[45:0] : shifted9[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag10 = shifted10 < {1'b0, b_i};
  wire [46:0] shifted11 = {(flag10 ? shifted10[45:0] : shifted10[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag11 = shifted11 < {1'b0, b_i};
  wire [46:0] shifted12 = {(flag11 ? shifted11[45:0] : shifted11[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag12 = shifted12 < {1'b0, b_i};
  wire [46:0] shifted13 = {(flag12 ? shifted12[45:0] : shifted12[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag13 = shifted13 < {1'b0, b_i};
  wire [46:0] shifted14 = {(flag13 ? shifted13[45:0] : shifted13[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag14 = shifted14 < {1'b0, b_i};
  wire [46:0] shifted15 = {(flag14 ? shifted14[45:0] : shifted14[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag15 = shifted15 < {1'b0, b_i};
  wire [46:0] shifted16 = {(flag15 ? shifted15[45:0] : shifted15[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag16 = shifted16 < {1'b0, b_i};
  wire [46:0] shifted17 = {(flag16 ? shifted16[45:0] : shifted16[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag17 = shifted17 < {1'b0, b_i};
  wire [46:0] shifted18 = {(flag17 ? shifted17[45:0] : shifted17[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag18 = shifted18 < {1'b0, b_i};
  wire [46:0] shifted19 = {(flag18 ? shifted18[45:0] : shifted18[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag19 = shifted19 < {1'b0, b_i};
  wire [46:0] shifted20 = {(flag19 ? shifted19[45:0] : shifted19[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag20 = shifted20 < {1'b0, b_i};
  wire [46:0] shifted21 = {(flag20 ? shifted20[45:0] : shifted20[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag21 = shifted21 < {1'b0, b_i};
  wire [46:0] shifted22 = {(flag21 ? shifted21[45:0] : shifted21[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag22 = shifted22 < {1'b0, b_i};
  wire [46:0] shifted23 = {(flag22 ? shifted22[45:0] : shifted22[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag23 = shifted23 < {1'b0, b_i};
  wire [46:0] shifted24 = {(flag23 ? shifted23[45:0] : shifted23[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag24 = shifted24 < {1'b0, b_i};
  wire [46:0] shifted25 = {(flag24 ? shifted24[45:0] : shifted24[45:0] - b_i) & 46'd70368744177663, 1'b0};
  wire flag25 = shifted25 < {1'b0, b_i};

  assign q_o = (((((((((((((((((((((((({flag == 1'd0, 25'b0} | {1'b0, flag2 == 1'd0, 24'b0}) | {2'b0, flag3 == 1'd0, 23'b0}) | {3'b0, flag4 == 1'd0, 22'b0}) | {4'b0, flag5 == 1'd0, 21'b0}) | {5'b0, flag6 == 1'd0, 20'b0}) | {6'b0, flag7 == 1'd0, 19'b0}) | {7'b0, flag8 == 1'd0, 18'b0}) | {8'b0, flag9 == 1'd0, 17'b0}) | {9'b0, flag10 == 1'd0, 16'b0}) | {10'b0, flag11 == 1'd0, 15'b0}) | {11'b0, flag12 == 1'd0, 14'b0}) | {12'b0, flag13 == 1'd0, 13'b0}) | {13'b0, flag14 == 1'd0, 12'b0}) | {14'b0, flag15 == 1'd0, 11'b0}) | {15'b0, flag16 == 1'd0, 10'b0}) | {16'b0, flag17 == 1'd0, 9'b0}) | {17'b0, flag18 == 1'd0, 8'b0}) | {18'b0, flag19 == 1'd0, 7'b0}) | {19'b0, flag20 == 1'd0, 6'b0}) | {20'b0, flag21 == 1'd0, 5'b0}) | {21'b0, flag22 == 1'd0, 4'b0}) | {22'b0, flag23 == 1'd0, 3'b0}) | {23'b0, flag24 == 1'd0, 2'b0}) | {24'b0, flag25 == 1'd0, 1'b0}) | {25'b0, ({(flag25 ? shifted25[45:0] : shifted25[45:0] - b_i) & 46'd70368744177663, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
