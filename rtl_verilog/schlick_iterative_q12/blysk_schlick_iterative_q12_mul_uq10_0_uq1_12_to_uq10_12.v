// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q12_mul_uq10_0_uq1_12_to_uq10_12 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    output wire [21:0] p_o  // UQ10.12
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
