// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_mul_sqm5_15_uq0_11_to_sqm5_26 (
    input  wire signed [10:0] a_i,  // SQ-5.15
    input  wire [10:0] b_i,  // UQ0.11
    output wire signed [21:0] p_o  // SQ-5.26
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
