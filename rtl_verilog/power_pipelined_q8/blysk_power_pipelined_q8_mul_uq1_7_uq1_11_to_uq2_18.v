// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_mul_uq1_7_uq1_11_to_uq2_18 (
    input  wire [7:0] a_i,  // UQ1.7, codes 0..128
    input  wire [11:0] b_i,  // UQ1.11
    output wire [19:0] p_o  // UQ2.18
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
