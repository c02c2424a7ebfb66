// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_mul_uq10_0_uq1_24_to_uq11_24 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [24:0] b_i,  // UQ1.24
    output wire [34:0] p_o  // UQ11.24
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
