// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_mul_uq1_8_uq8_0_to_uq8_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire [7:0] b_i,  // UQ8.0
    output wire [15:0] p_o  // UQ8.8
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
