// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_mul_uq10_0_uq0_18_to_uq10_18 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [17:0] b_i,  // UQ0.18
    output wire [27:0] p_o  // UQ10.18
);

  assign p_o = {18'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
