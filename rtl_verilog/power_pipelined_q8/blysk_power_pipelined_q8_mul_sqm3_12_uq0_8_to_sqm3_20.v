// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_mul_sqm3_12_uq0_8_to_sqm3_20 (
    input  wire signed [9:0] a_i,  // SQ-3.12
    input  wire [7:0] b_i,  // UQ0.8
    output wire signed [17:0] p_o  // SQ-3.20
);

  assign p_o = a_i * $signed({1'b0, b_i});

endmodule

`default_nettype wire
