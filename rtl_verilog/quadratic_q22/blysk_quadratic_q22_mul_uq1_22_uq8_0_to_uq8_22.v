// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_mul_uq1_22_uq8_0_to_uq8_22 (
    input  wire [22:0] a_i,  // UQ1.22, codes 0..4194304
    input  wire [7:0] b_i,  // UQ8.0
    output wire [29:0] p_o  // UQ8.22
);

  assign p_o = {7'b0, a_i} * {22'b0, b_i};

endmodule

`default_nettype wire
