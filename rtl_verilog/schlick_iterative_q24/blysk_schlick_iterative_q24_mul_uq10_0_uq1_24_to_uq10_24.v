// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device schlick-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q24_mul_uq10_0_uq1_24_to_uq10_24 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [33:0] p_o  // UQ10.24
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
