// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device gx, format q16, a combinational divider, exported from the SystemC model.
`default_nettype none

module blysk_gx_q16_divide_uq1_28_uq9_29_to_uq1_17 (
    input  wire [28:0] a_i,  // UQ1.28, codes 0..268435456
    input  wire [37:0] b_i,  // UQ9.29
    output wire [17:0] q_o  // UQ1.17, codes 0..131072
);

  wire [29:0] shifted = {a_i, 1'b0};
  wire flag = {8'b0, shifted} < b_i;
  wire [38:0] shifted2 = {(flag ? {8'b0, shifted} : {8'b0, shifted} - b_i) & 38'd274877906943, 1'b0};
  wire flag2 = shifted2 < {1'b0, b_i};
  wire [38:0] shifted3 = {(flag2 ? shifted2[37:0] : shifted2[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag3 = shifted3 < {1'b0, b_i};
  wire [38:0] shifted4 = {(flag3 ? shifted3[37:0] : shifted3[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag4 = shifted4 < {1'b0, b_i};
  wire [38:0] shifted5 = {(flag4 ? shifted4[37:0] : shifted4[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag5 = shifted5 < {1'b0, b_i};
  wire [38:0] shifted6 = {(flag5 ? shifted5[37:0] : shifted5[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag6 = shifted6 < {1'b0, b_i};
  wire [38:0] shifted7 = {(flag6 ? shifted6[37:0] : shifted6[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag7 = shifted7 < {1'b0, b_i};
  wire [38:0] shifted8 = {(flag7 ? shifted7[37:0] : shifted7[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag8 = shifted8 < {1'b0, b_i};
  wire [38:0] shifted9 = {(flag8 ? shifted8[37:0] : shifted8[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag9 = shifted9 < {1'b0, b_i};
  wire [38:0] shifted10 = {(flag9 ? shifted9[37:0] : shifted9[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag10 = shifted10 < {1'b0, b_i};
  wire [38:0] shifted11 = {(flag10 ? shifted10[37:0] : shifted10[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag11 = shifted11 < {1'b0, b_i};
  wire [38:0] shifted12 = {(flag11 ? shifted11[37:0] : shifted11[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag12 = shifted12 < {1'b0, b_i};
  wire [38:0] shifted13 = {(flag12 ? shifted12[37:0] : shifted12[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag13 = shifted13 < {1'b0, b_i};
  wire [38:0] shifted14 = {(flag13 ? shifted13[37:0] : shifted13[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag14 = shifted14 < {1'b0, b_i};
  wire [38:0] shifted15 = {(flag14 ? shifted14[37:0] : shifted14[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag15 = shifted15 < {1'b0, b_i};
  wire [38:0] shifted16 = {(flag15 ? shifted15[37:0] : shifted15[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag16 = shifted16 < {1'b0, b_i};
  wire [38:0] shifted17 = {(flag16 ? shifted16[37:0] : shifted16[37:0] - b_i) & 38'd274877906943, 1'b0};
  wire flag17 = shifted17 < {1'b0, b_i};

  assign q_o = (((((((((((((((({flag == 1'd0, 17'b0} | {1'b0, flag2 == 1'd0, 16'b0}) | {2'b0, flag3 == 1'd0, 15'b0}) | {3'b0, flag4 == 1'd0, 14'b0}) | {4'b0, flag5 == 1'd0, 13'b0}) | {5'b0, flag6 == 1'd0, 12'b0}) | {6'b0, flag7 == 1'd0, 11'b0}) | {7'b0, flag8 == 1'd0, 10'b0}) | {8'b0, flag9 == 1'd0, 9'b0}) | {9'b0, flag10 == 1'd0, 8'b0}) | {10'b0, flag11 == 1'd0, 7'b0}) | {11'b0, flag12 == 1'd0, 6'b0}) | {12'b0, flag13 == 1'd0, 5'b0}) | {13'b0, flag14 == 1'd0, 4'b0}) | {14'b0, flag15 == 1'd0, 3'b0}) | {15'b0, flag16 == 1'd0, 2'b0}) | {16'b0, flag17 == 1'd0, 1'b0}) | {17'b0, ({(flag17 ? shifted17[37:0] : shifted17[37:0] - b_i) & 38'd274877906943, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
