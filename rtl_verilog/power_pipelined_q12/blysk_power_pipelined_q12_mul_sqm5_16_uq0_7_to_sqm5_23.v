// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_mul_sqm5_16_uq0_7_to_sqm5_23 (
    input  wire signed [11:0] a_i,  // SQ-5.16
    input  wire [6:0] b_i,  // UQ0.7
    output wire signed [18:0] p_o  // SQ-5.23
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
