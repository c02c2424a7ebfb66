// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_mul_uq1_11_uq1_15_to_uq2_26 (
    input  wire [11:0] a_i,  // UQ1.11, codes 0..2048
    input  wire [15:0] b_i,  // UQ1.15
    output wire [27:0] p_o  // UQ2.26
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
