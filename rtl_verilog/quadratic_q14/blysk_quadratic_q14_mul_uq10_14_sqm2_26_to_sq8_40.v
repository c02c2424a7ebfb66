// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_mul_uq10_14_sqm2_26_to_sq8_40 (
    input  wire [23:0] a_i,  // UQ10.14
    input  wire signed [24:0] b_i,  // SQ-2.26
    output wire signed [48:0] p_o  // SQ8.40
);

  assign p_o = {25'b0, a_i} * {{24{b_i[24]}}, b_i};

endmodule

`default_nettype wire
