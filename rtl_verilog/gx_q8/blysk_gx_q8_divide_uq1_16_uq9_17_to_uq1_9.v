// SPDX-License-Identifier: Apache-2.0
// Divider: q_o = a_i / b_i, rounded down, for a_i <= b_i.
// device gx, format q8, a combinational divider, exported from the SystemC model.
`default_nettype none

module blysk_gx_q8_divide_uq1_16_uq9_17_to_uq1_9 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire [25:0] b_i,  // UQ9.17
    output wire [9:0] q_o  // UQ1.9, codes 0..512
);

  wire [17:0] shifted = {a_i, 1'b0};
  wire flag = {8'b0, shifted} < b_i;
  wire [26:0] shifted2 = {(flag ? {8'b0, shifted} : {8'b0, shifted} - b_i) & 26'd67108863, 1'b0};
  wire flag2 = shifted2 < {1'b0, b_i};
  wire [26:0] shifted3 = {(flag2 ? shifted2[25:0] : shifted2[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag3 = shifted3 < {1'b0, b_i};
  wire [26:0] shifted4 = {(flag3 ? shifted3[25:0] : shifted3[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag4 = shifted4 < {1'b0, b_i};
  wire [26:0] shifted5 = {(flag4 ? shifted4[25:0] : shifted4[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag5 = shifted5 < {1'b0, b_i};
  wire [26:0] shifted6 = {(flag5 ? shifted5[25:0] : shifted5[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag6 = shifted6 < {1'b0, b_i};
  wire [26:0] shifted7 = {(flag6 ? shifted6[25:0] : shifted6[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag7 = shifted7 < {1'b0, b_i};
  wire [26:0] shifted8 = {(flag7 ? shifted7[25:0] : shifted7[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag8 = shifted8 < {1'b0, b_i};
  wire [26:0] shifted9 = {(flag8 ? shifted8[25:0] : shifted8[25:0] - b_i) & 26'd67108863, 1'b0};
  wire flag9 = shifted9 < {1'b0, b_i};

  assign q_o = (((((((({flag == 1'd0, 9'b0} | {1'b0, flag2 == 1'd0, 8'b0}) | {2'b0, flag3 == 1'd0, 7'b0}) | {3'b0, flag4 == 1'd0, 6'b0}) | {4'b0, flag5 == 1'd0, 5'b0}) | {5'b0, flag6 == 1'd0, 4'b0}) | {6'b0, flag7 == 1'd0, 3'b0}) | {7'b0, flag8 == 1'd0, 2'b0}) | {8'b0, flag9 == 1'd0, 1'b0}) | {9'b0, ({(flag9 ? shifted9[25:0] : shifted9[25:0] - b_i) & 26'd67108863, 1'b0} < {1'b0, b_i}) == 1'd0};

endmodule

`default_nettype wire
