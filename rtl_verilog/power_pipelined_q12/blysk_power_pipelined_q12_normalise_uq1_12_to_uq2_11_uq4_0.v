// SPDX-License-Identifier: Apache-2.0
// Normaliser: a_i = m_o 2^(-zeros_o - 1), 1 <= m_o <= 2; zero_o: a_i is 0.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_normalise_uq1_12_to_uq2_11_uq4_0 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire [12:0] m_o,  // UQ2.11
    output wire [3:0] zeros_o,  // UQ4.0
    output wire zero_o
);

  wire flag = a_i[12:4] == 9'd0;
  wire [12:0] selected = flag ? {1'b0, {a_i[3:0], 8'b0} & 12'd4095} : a_i;
  wire flag2 = selected[12:8] == 5'd0;
  wire [12:0] selected2 = flag2 ? {1'b0, {selected[7:0], 4'b0} & 12'd4095} : selected;
  wire flag3 = selected2[12:10] == 3'd0;
  wire [12:0] selected3 = flag3 ? {1'b0, {selected2[9:0], 2'b0} & 12'd4095} : selected2;
  wire flag4 = selected3[12:11] == 2'd0;
  wire [12:0] selected4 = flag4 ? {1'b0, {selected3[10:0], 1'b0} & 12'd4095} : selected3;
  wire flag5 = selected4[12:11] == 2'd0;

  assign m_o = selected4 | {1'b0, flag5, 11'b0};
  assign zeros_o = (({flag, 3'b0} | {1'b0, flag2, 2'b0}) | {2'b0, flag3, 1'b0}) | {3'b0, flag4};
  assign zero_o = flag5;

endmodule

`default_nettype wire
