// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_mul_sqm11_28_uq0_13_to_sqm11_41 (
    input  wire signed [17:0] a_i,  // SQ-11.28
    input  wire [12:0] b_i,  // UQ0.13
    output wire signed [30:0] p_o  // SQ-11.41
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
