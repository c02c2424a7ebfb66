// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_mul_uq10_0_uq4_28_to_uq14_28 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [31:0] b_i,  // UQ4.28
    output wire [41:0] p_o  // UQ14.28
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
