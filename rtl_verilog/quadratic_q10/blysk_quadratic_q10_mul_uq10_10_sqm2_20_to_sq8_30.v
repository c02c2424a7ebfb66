// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_mul_uq10_10_sqm2_20_to_sq8_30 (
    input  wire [19:0] a_i,  // UQ10.10
    input  wire signed [18:0] b_i,  // SQ-2.20
    output wire signed [38:0] p_o  // SQ8.30
);

  assign p_o = {19'b0, a_i} * {{20{b_i[18]}}, b_i};

endmodule

`default_nettype wire
