// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_mul_sqm5_11_uq0_7_to_sqm5_18 (
    input  wire signed [6:0] a_i,  // SQ-5.11
    input  wire [6:0] b_i,  // UQ0.7
    output wire signed [13:0] p_o  // SQ-5.18
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
