// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_mul_uq1_24_uq8_0_to_uq8_24 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [7:0] b_i,  // UQ8.0
    output wire [31:0] p_o  // UQ8.24
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
