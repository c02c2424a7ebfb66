// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_mul_sqm5_19_uq0_15_to_sqm5_34 (
    input  wire signed [14:0] a_i,  // SQ-5.19
    input  wire [14:0] b_i,  // UQ0.15
    output wire signed [29:0] p_o  // SQ-5.34
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
