// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_mul_uq10_20_sqm2_34_to_sq8_54 (
    input  wire [29:0] a_i,  // UQ10.20
    input  wire signed [32:0] b_i,  // SQ-2.34
    output wire signed [62:0] p_o  // SQ8.54
);

  assign p_o = {33'b0, a_i} * {{30{b_i[32]}}, b_i};

endmodule

`default_nettype wire
