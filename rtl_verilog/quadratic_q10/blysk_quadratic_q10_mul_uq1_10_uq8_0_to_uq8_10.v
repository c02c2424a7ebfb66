// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_mul_uq1_10_uq8_0_to_uq8_10 (
    input  wire [10:0] a_i,  // UQ1.10, codes 0..1024
    input  wire [7:0] b_i,  // UQ8.0
    output wire [17:0] p_o  // UQ8.10
);

  assign p_o = {7'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
