// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_mul_uq10_20_sqm2_35_to_sq8_55 (
    input  wire [29:0] a_i,  // UQ10.20
    input  wire signed [33:0] b_i,  // SQ-2.35
    output wire signed [63:0] p_o  // SQ8.55
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
