// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_mul_uq1_15_uq1_19_to_uq2_34 (
    input  wire [15:0] a_i,  // UQ1.15, codes 0..32768
    input  wire [19:0] b_i,  // UQ1.19
    output wire [35:0] p_o  // UQ2.34
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
