// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gx-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q16_add_uq9_29_uq1_28_to_uq9_29 (
    input  wire [37:0] a_i,  // UQ9.29
    input  wire [28:0] b_i,  // UQ1.28, codes 0..268435456
    input  wire carry_i,
    output wire [37:0] s_o  // UQ9.29
);

  assign s_o = a_i + {8'b0, b_i, 1'b0} + {37'b0, carry_i};

endmodule

`default_nettype wire
