// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_add_uq1_0_uq10_19_to_uq10_19 (
    input  wire a_i,  // UQ1.0
    input  wire [28:0] b_i,  // UQ10.19
    input  wire carry_i,
    output wire [28:0] s_o  // UQ10.19
);

  assign s_o = {9'b0, a_i, 19'b0} + b_i + {28'b0, carry_i};

endmodule

`default_nettype wire
