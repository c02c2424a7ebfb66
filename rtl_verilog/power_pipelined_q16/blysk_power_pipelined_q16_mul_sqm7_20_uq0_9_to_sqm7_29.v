// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_mul_sqm7_20_uq0_9_to_sqm7_29 (
    input  wire signed [13:0] a_i,  // SQ-7.20
    input  wire [8:0] b_i,  // UQ0.9
    output wire signed [22:0] p_o  // SQ-7.29
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
