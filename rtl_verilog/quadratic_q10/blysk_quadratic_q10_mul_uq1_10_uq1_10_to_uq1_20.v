// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_mul_uq1_10_uq1_10_to_uq1_20 (
    input  wire [10:0] a_i,  // UQ1.10, codes 0..1024
    input  wire [10:0] b_i,  // UQ1.10, codes 0..1024
    output wire [20:0] p_o  // UQ1.20
);

  assign p_o = {10'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
