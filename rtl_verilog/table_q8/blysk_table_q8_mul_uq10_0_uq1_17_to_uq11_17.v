// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_mul_uq10_0_uq1_17_to_uq11_17 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [17:0] b_i,  // UQ1.17
    output wire [27:0] p_o  // UQ11.17
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
