// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_mul_uq1_20_uq8_0_to_uq8_20 (
    input  wire [20:0] a_i,  // UQ1.20, codes 0..1048576
    input  wire [7:0] b_i,  // UQ8.0
    output wire [27:0] p_o  // UQ8.20
);

  assign p_o = {7'b0, a_i} * {20'b0, b_i};

endmodule

`default_nettype wire
