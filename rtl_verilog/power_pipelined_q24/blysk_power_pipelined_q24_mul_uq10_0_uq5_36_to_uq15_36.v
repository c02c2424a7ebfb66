// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_mul_uq10_0_uq5_36_to_uq15_36 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [40:0] b_i,  // UQ5.36
    output wire [50:0] p_o  // UQ15.36
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
