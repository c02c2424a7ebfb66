// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_mul_uq10_0_uq3_17_to_uq13_17 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [19:0] b_i,  // UQ3.17
    output wire [29:0] p_o  // UQ13.17
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
