// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_mul_uq10_16_sqm2_28_to_sq8_44 (
    input  wire [25:0] a_i,  // UQ10.16
    input  wire signed [26:0] b_i,  // SQ-2.28
    output wire signed [52:0] p_o  // SQ8.44
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
