// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_mul_uq10_0_uq0_16_to_uq10_16 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [15:0] b_i,  // UQ0.16
    output wire [25:0] p_o  // UQ10.16
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
