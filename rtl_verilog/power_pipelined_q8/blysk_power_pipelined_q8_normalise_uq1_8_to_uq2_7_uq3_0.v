// SPDX-License-Identifier: Apache-2.0
// Normaliser: a_i = m_o 2^(-zeros_o - 1), 1 <= m_o <= 2; zero_o: a_i is 0.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_normalise_uq1_8_to_uq2_7_uq3_0 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire [8:0] m_o,  // UQ2.7
    output wire [2:0] zeros_o,  // UQ3.0
    output wire zero_o
);

  wire flag = a_i[8:4] == 5'd0;
  wire [8:0] selected = flag ? {1'b0, {a_i[3:0], 4'b0} & 8'd255} : a_i;
  wire flag2 = selected[8:6] == 3'd0;
  wire [8:0] selected2 = flag2 ? {1'b0, {selected[5:0], 2'b0} & 8'd255} : selected;
  wire flag3 = selected2[8:7] == 2'd0;
  wire [8:0] selected3 = flag3 ? {1'b0, {selected2[6:0], 1'b0} & 8'd255} : selected2;
  wire flag4 = selected3[8:7] == 2'd0;

  assign m_o = selected3 | {1'b0, flag4, 7'b0};
  assign zeros_o = ({flag, 2'b0} | {1'b0, flag2, 1'b0}) | {2'b0, flag3};
  assign zero_o = flag4;

endmodule

`default_nettype wire
