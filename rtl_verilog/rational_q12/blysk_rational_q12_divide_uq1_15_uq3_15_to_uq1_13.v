// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device rational, format q12, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q12_divide_uq1_15_uq3_15_to_uq1_13 (
    input  wire [15:0] a_i,  // UQ1.15, codes 0..32768
    input  wire [17:0] b_i,  // UQ3.15
    output wire [13:0] q_o  // UQ1.13, codes 0..8192
);

  wire flag = {2'b0, a_i} < b_i;
  wire [18:0] shifted = {(flag ? {2'b0, a_i} : {2'b0, a_i} - b_i) & 18'd262143, 1'b0};
  wire flag2 = shifted < {1'b0, b_i};
  wire [18:0] shifted2 = {(flag2 ? shifted[17:0] : shifted[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag3 = shifted2 < {1'b0, b_i};
  wire [18:0] shifted3 = {(flag3 ? shifted2[17:0] : shifted2[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag4 = shifted3 < {1'b0, b_i};
  wire [18:0] shifted4 = {(flag4 ? shifted3[17:0] : shifted3[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag5 = shifted4 < {1'b0, b_i};
  wire [18:0] shifted5 = {(flag5 ? shifted4[17:0] : shifted4[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag6 = shifted5 < {1'b0, b_i};
  wire [18:0] shifted6 = {(flag6 ? shifted5[17:0] : shifted5[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag7 = shifted6 < {1'b0, b_i};
  wire [18:0] shifted7 = {(flag7 ? shifted6[17:0] : shifted6[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag8 = shifted7 < {1'b0, b_i};
  wire [18:0] shifted8 = {(flag8 ? shifted7[17:0] : shifted7[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag9 = shifted8 < {1'b0, b_i};
  wire [18:0] shifted9 = {(flag9 ? shifted8[17:0] : shifted8[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag10 = shifted9 < {1'b0, b_i};
  wire [18:0] shifted10 = {(flag10 ? shifted9[17:0] : shifted9[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag11 = shifted10 < {1'b0, b_i};
  wire [18:0] shifted11 = {(flag11 ? shifted10[17:0] : shifted10[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag12 = shifted11 < {1'b0, b_i};
  wire [18:0] shifted12 = {(flag12 ? shifted11[17:0] : shifted11[17:0] - b_i) & 18'd262143, 1'b0};
  wire flag13 = shifted12 < {1'b0, b_i};

  assign q_o = (((((((((((({flag == 1'd0, 13'b0} | {1'b0, flag2 == 1'd0, 12'b0}) | {2'b0, flag3 == 1'd0, 11'b0}) | {3'b0, flag4 == 1'd0, 10'b0}) | {4'b0, flag5 == 1'd0, 9'b0}) | {5'b0, flag6 == 1'd0, 8'b0}) | {6'b0, flag7 == 1'd0, 7'b0}) | {7'b0, flag8 == 1'd0, 6'b0}) | {8'b0, flag9 == 1'd0, 5'b0}) | {9'b0, flag10 == 1'd0, 4'b0}) | {10'b0, flag11 == 1'd0, 3'b0}) | {11'b0, flag12 == 1'd0, 2'b0}) | {12'b0, flag13 == 1'd0, 1'b0}) | {13'b0, ({(flag13 ? shifted12[17:0] : shifted12[17:0] - b_i) & 18'd262143, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
