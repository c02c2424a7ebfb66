// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q12_mul_uq9_1_uq1_24_to_uq9_25 (
    input  wire [9:0] a_i,  // UQ9.1
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [33:0] p_o  // UQ9.25
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
