// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_add_uq9_37_uq1_36_to_uq9_37 (
    input  wire [45:0] a_i,  // UQ9.37
    input  wire [36:0] b_i,  // UQ1.36, codes 0..68719476736
    input  wire carry_i,
    output wire [45:0] s_o  // UQ9.37
);

  assign s_o = a_i + {8'b0, b_i, 1'b0} + {45'b0, carry_i};

endmodule

`default_nettype wire
