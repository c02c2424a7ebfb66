// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device rational, format q8, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q8_divide_uq1_11_uq3_11_to_uq1_9 (
    input  wire [11:0] a_i,  // UQ1.11, codes 0..2048
    input  wire [13:0] b_i,  // UQ3.11
    output wire [9:0] q_o  // UQ1.9, codes 0..512
);

  wire flag = {2'b0, a_i} < b_i;
  wire [14:0] shifted = {(flag ? {2'b0, a_i} : {2'b0, a_i} - b_i) & 14'd16383, 1'b0};
  wire flag2 = shifted < {1'b0, b_i};
  wire [14:0] shifted2 = {(flag2 ? shifted[13:0] : shifted[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag3 = shifted2 < {1'b0, b_i};
  wire [14:0] shifted3 = {(flag3 ? shifted2[13:0] : shifted2[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag4 = shifted3 < {1'b0, b_i};
  wire [14:0] shifted4 = {(flag4 ? shifted3[13:0] : shifted3[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag5 = shifted4 < {1'b0, b_i};
  wire [14:0] shifted5 = {(flag5 ? shifted4[13:0] : shifted4[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag6 = shifted5 < {1'b0, b_i};
  wire [14:0] shifted6 = {(flag6 ? shifted5[13:0] : shifted5[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag7 = shifted6 < {1'b0, b_i};
  wire [14:0] shifted7 = {(flag7 ? shifted6[13:0] : shifted6[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag8 = shifted7 < {1'b0, b_i};
  wire [14:0] shifted8 = {(flag8 ? shifted7[13:0] : shifted7[13:0] - b_i) & 14'd16383, 1'b0};
  wire flag9 = shifted8 < {1'b0, b_i};

  assign q_o = (((((((({flag == 1'd0, 9'b0} | {1'b0, flag2 == 1'd0, 8'b0}) | {2'b0, flag3 == 1'd0, 7'b0}) | {3'b0, flag4 == 1'd0, 6'b0}) | {4'b0, flag5 == 1'd0, 5'b0}) | {5'b0, flag6 == 1'd0, 4'b0}) | {6'b0, flag7 == 1'd0, 3'b0}) | {7'b0, flag8 == 1'd0, 2'b0}) | {8'b0, flag9 == 1'd0, 1'b0}) | {9'b0, ({(flag9 ? shifted8[13:0] : shifted8[13:0] - b_i) & 14'd16383, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
