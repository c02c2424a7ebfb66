// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_mul_uq1_23_uq1_27_to_uq2_50 (
    input  wire [23:0] a_i,  // UQ1.23, codes 0..8388608
    input  wire [27:0] b_i,  // UQ1.27
    output wire [51:0] p_o  // UQ2.50
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
