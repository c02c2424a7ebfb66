// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q12_add_uq10_12_uq1_12_to_uq10_12 (
    input  wire [21:0] a_i,  // UQ10.12
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    input  wire carry_i,
    output wire [21:0] s_o  // UQ10.12
);

  assign s_o = a_i + {9'b0, b_i} + {21'b0, carry_i};

endmodule

`default_nettype wire
