// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_mul_uq1_15_uq5_13_to_uq6_28 (
    input  wire [15:0] a_i,  // UQ1.15
    input  wire [17:0] b_i,  // UQ5.13
    output wire [33:0] p_o  // UQ6.28
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
