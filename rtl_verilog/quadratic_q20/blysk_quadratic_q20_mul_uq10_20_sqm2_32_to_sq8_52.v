// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_mul_uq10_20_sqm2_32_to_sq8_52 (
    input  wire [29:0] a_i,  // UQ10.20
    input  wire signed [30:0] b_i,  // SQ-2.32
    output wire signed [60:0] p_o  // SQ8.52
);

  assign p_o = {31'b0, a_i} * {{30{b_i[30]}}, b_i};

endmodule

`default_nettype wire
