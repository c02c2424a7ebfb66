// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_mul_uq10_0_uq1_28_to_uq11_28 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [28:0] b_i,  // UQ1.28
    output wire [38:0] p_o  // UQ11.28
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
