// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_mul_uq10_0_uq4_24_to_uq14_24 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [27:0] b_i,  // UQ4.24
    output wire [37:0] p_o  // UQ14.24
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
