// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device rational, format q24, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q24_divide_uq1_27_uq3_27_to_uq1_25 (
    input  wire [27:0] a_i,  // UQ1.27, codes 0..134217728
    input  wire [29:0] b_i,  // UQ3.27
    output wire [25:0] q_o  // UQ1.25, codes 0..33554432
);

  wire flag = {2'b0, a_i} < b_i;
  wire [30:0] shifted = {(flag ? {2'b0, a_i} : {2'b0, a_i} - b_i) & 30'd1073741823, 1'b0};
  wire flag2 = shifted < {1'b0, b_i};
  wire [30:0] shifted2 = {(flag2 ? shifted[29:0] : shifted[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag3 = shifted2 < {1'b0, b_i};
  wire [30:0] shifted3 = {(flag3 ? shifted2[29:0] : shifted2[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag4 = shifted3 < {1'b0, b_i};
  wire [30:0] shifted4 = {(flag4 ? shifted3[29:0] : shifted3[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag5 = shifted4 < {1'b0, b_i};
  wire [30:0] shifted5 = {(flag5 ? shifted4[29:0] : shifted4[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag6 = shifted5 < {1'b0, b_i};
  wire [30:0] shifted6 = {(flag6 ? shifted5[29:0] : shifted5[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag7 = shifted6 < {1'b0, b_i};
  wire [30:0] shifted7 = {(flag7 ? shifted6[29:0] : shifted6[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag8 = shifted7 < {1'b0, b_i};
  wire [30:0] shifted8 = {(flag8 ? shifted7[29:0] : shifted7[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag9 = shifted8 < {1'b0, b_i};
  wire [30:0] shifted9 = {(flag9 ? shifted8[29:0] : shifted8[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag10 = shifted9 < {1'b0, b_i};
  wire [30:0] shifted10 = {(flag10 ? shifted9[29:0] : shifted9[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag11 = shifted10 < {1'b0, b_i};
  wire [30:0] shifted11 = {(flag11 ? shifted10[29:0] : shifted10[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag12 = shifted11 < {1'b0, b_i};
  wire [30:0] shifted12 = {(flag12 ? shifted11[29:0] : shifted11[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag13 = shifted12 < {1'b0, b_i};
  wire [30:0] shifted13 = {(flag13 ? shifted12[29:0] : shifted12[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag14 = shifted13 < {1'b0, b_i};
  wire [30:0] shifted14 = {(flag14 ? shifted13[29:0] : shifted13[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag15 = shifted14 < {1'b0, b_i};
  wire [30:0] shifted15 = {(flag15 ? shifted14[29:0] : shifted14[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag16 = shifted15 < {1'b0, b_i};
  wire [30:0] shifted16 = {(flag16 ? shifted15[29:0] : shifted15[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag17 = shifted16 < {1'b0, b_i};
  wire [30:0] shifted17 = {(flag17 ? shifted16[29:0] : shifted16[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag18 = shifted17 < {1'b0, b_i};
  wire [30:0] shifted18 = {(flag18 ? shifted17[29:0] : shifted17[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag19 = shifted18 < {1'b0, b_i};
  wire [30:0] shifted19 = {(flag19 ? shifted18[29:0] : shifted18[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag20 = shifted19 < {1'b0, b_i};
  wire [30:0] shifted20 = {(flag20 ? shifted19[29:0] : shifted19[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag21 = shifted20 < {1'b0, b_i};
  wire [30:0] shifted21 = {(flag21 ? shifted20[29:0] : shifted20[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag22 = shifted21 < {1'b0, b_i};
  wire [30:0] shifted22 = {(flag22 ? shifted21[29:0] : shifted21[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag23 = shifted22 < {1'b0, b_i};
  wire [30:0] shifted23 = {(flag23 ? shifted22[29:0] : shifted22[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag24 = shifted23 < {1'b0, b_i};
  wire [30:0] shifted24 = {(flag24 ? shifted23[29:0] : shifted23[29:0] - b_i) & 30'd1073741823, 1'b0};
  wire flag25 = shifted24 < {1'b0, b_i};

  assign q_o = (((((((((((((((((((((((({flag == 1'd0, 25'b0} | {1'b0, flag2 == 1'd0, 24'b0}) | {2'b0, flag3 == 1'd0, 23'b0}) | {3'b0, flag4 == 1'd0, 22'b0}) | {4'b0, flag5 == 1'd0, 21'b0}) | {5'b0, flag6 == 1'd0, 20'b0}) | {6'b0, flag7 == 1'd0, 19'b0}) | {7'b0, flag8 == 1'd0, 18'b0}) | {8'b0, flag9 == 1'd0, 17'b0}) | {9'b0, flag10 == 1'd0, 16'b0}) | {10'b0, flag11 == 1'd0, 15'b0}) | {11'b0, flag12 == 1'd0, 14'b0}) | {12'b0, flag13 == 1'd0, 13'b0}) | {13'b0, flag14 == 1'd0, 12'b0}) | {14'b0, flag15 == 1'd0, 11'b0}) | {15'b0, flag16 == 1'd0, 10'b0}) | {16'b0, flag17 == 1'd0, 9'b0}) | {17'b0, flag18 == 1'd0, 8'b0}) | {18'b0, flag19 == 1'd0, 7'b0}) | {19'b0, flag20 == 1'd0, 6'b0}) | {20'b0, flag21 == 1'd0, 5'b0}) | {21'b0, flag22 == 1'd0, 4'b0}) | {22'b0, flag23 == 1'd0, 3'b0}) | {23'b0, flag24 == 1'd0, 2'b0}) | {24'b0, flag25 == 1'd0, 1'b0}) | {25'b0, ({(flag25 ? shifted24[29:0] : shifted24[29:0] - b_i) & 30'd1073741823, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
