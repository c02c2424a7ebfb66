// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_mul_uq10_18_sqm2_30_to_sq8_48 (
    input  wire [27:0] a_i,  // UQ10.18
    input  wire signed [28:0] b_i,  // SQ-2.30
    output wire signed [56:0] p_o  // SQ8.48
);

  assign p_o = {29'b0, a_i} * {{28{b_i[28]}}, b_i};

endmodule

`default_nettype wire
