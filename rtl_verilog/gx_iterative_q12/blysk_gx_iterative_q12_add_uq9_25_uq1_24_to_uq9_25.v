// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gx-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q12_add_uq9_25_uq1_24_to_uq9_25 (
    input  wire [33:0] a_i,  // UQ9.25
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    input  wire carry_i,
    output wire [33:0] s_o  // UQ9.25
);

  assign s_o = a_i + {8'b0, b_i, 1'b0} + {33'b0, carry_i};

endmodule

`default_nettype wire
