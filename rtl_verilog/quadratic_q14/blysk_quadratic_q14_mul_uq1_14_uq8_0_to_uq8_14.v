// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_mul_uq1_14_uq8_0_to_uq8_14 (
    input  wire [14:0] a_i,  // UQ1.14, codes 0..16384
    input  wire [7:0] b_i,  // UQ8.0
    output wire [21:0] p_o  // UQ8.14
);

  assign p_o = {7'b0, a_i} * {14'b0, b_i};

endmodule

`default_nettype wire
