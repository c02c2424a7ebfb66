// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_mul_uq1_18_uq8_0_to_uq8_18 (
    input  wire [18:0] a_i,  // UQ1.18, codes 0..262144
    input  wire [7:0] b_i,  // UQ8.0
    output wire [25:0] p_o  // UQ8.18
);

  assign p_o = {7'b0, a_i} * {18'b0, b_i};

endmodule

`default_nettype wire
