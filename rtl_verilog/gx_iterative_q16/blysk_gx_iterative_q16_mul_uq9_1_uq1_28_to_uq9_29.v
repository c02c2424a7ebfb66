// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q16_mul_uq9_1_uq1_28_to_uq9_29 (
    input  wire [9:0] a_i,  // UQ9.1
    input  wire [28:0] b_i,  // UQ1.28, codes 0..268435456
    output wire [37:0] p_o  // UQ9.29
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
