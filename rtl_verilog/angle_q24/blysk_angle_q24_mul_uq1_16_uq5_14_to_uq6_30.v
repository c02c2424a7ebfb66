// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_mul_uq1_16_uq5_14_to_uq6_30 (
    input  wire [16:0] a_i,  // UQ1.16
    input  wire [18:0] b_i,  // UQ5.14
    output wire [35:0] p_o  // UQ6.30
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
