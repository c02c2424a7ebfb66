// SPDX-License-Identifier: Apache-2.0
// Normaliser: a_i = m_o 2^(-zeros_o - 1), 1 <= m_o <= 2; zero_o: a_i is 0.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_normalise_uq1_24_to_uq2_23_uq5_0 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    output wire [24:0] m_o,  // UQ2.23
    output wire [4:0] zeros_o,  // UQ5.0
    output wire zero_o
);

  wire flag = a_i[24:8] == 17'd0;
  wire [24:0] selected = flag ? {1'b0, {a_i[7:0], 16'b0} & 24'd16777215} : a_i;
  wire flag2 = selected[24:16] == 9'd0;
  wire [24:0] selected2 = flag2 ? {1'b0, {selected[15:0], 8'b0} & 24'd16777215} : selected;
  wire flag3 = selected2[24:20] == 5'd0;
  wire [24:0] selected3 = flag3 ? {1'b0, {selected2[19:0], 4'b0} & 24'd16777215} : selected2;
  wire flag4 = selected3[24:22] == 3'd0;
  wire [24:0] selected4 = flag4 ? {1'b0, {selected3[21:0], 2'b0} & 24'd16777215} : selected3;
  wire flag5 = selected4[24:23] == 2'd0;
  wire [24:0] selected5 = flag5 ? {1'b0, {selected4[22:0], 1'b0} & 24'd16777215} : selected4;
  wire flag6 = selected5[24:23] == 2'd0;

  assign m_o = selected5 | {1'b0, flag6, 23'b0};
  assign zeros_o = ((({flag, 4'b0} | {1'b0, flag2, 3'b0}) | {2'b0, flag3, 2'b0}) | {3'b0, flag4, 1'b0}) | {4'b0, flag5};
  assign zero_o = flag6;

endmodule

`default_nettype wire
