// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_mul_uq10_8_sqm2_16_to_sq8_24 (
    input  wire [17:0] a_i,  // UQ10.8
    input  wire signed [14:0] b_i,  // SQ-2.16
    output wire signed [32:0] p_o  // SQ8.24
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
