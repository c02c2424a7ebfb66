// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_mul_uq1_16_uq8_0_to_uq8_16 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire [7:0] b_i,  // UQ8.0
    output wire [23:0] p_o  // UQ8.16
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
