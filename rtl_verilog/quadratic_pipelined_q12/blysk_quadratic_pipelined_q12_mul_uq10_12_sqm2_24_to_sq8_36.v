// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_mul_uq10_12_sqm2_24_to_sq8_36 (
    input  wire [21:0] a_i,  // UQ10.12
    input  wire signed [22:0] b_i,  // SQ-2.24
    output wire signed [44:0] p_o  // SQ8.36
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
