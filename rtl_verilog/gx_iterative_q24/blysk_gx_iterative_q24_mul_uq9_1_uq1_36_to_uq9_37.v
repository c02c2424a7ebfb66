// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_mul_uq9_1_uq1_36_to_uq9_37 (
    input  wire [9:0] a_i,  // UQ9.1
    input  wire [36:0] b_i,  // UQ1.36, codes 0..68719476736
    output wire [45:0] p_o  // UQ9.37
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
