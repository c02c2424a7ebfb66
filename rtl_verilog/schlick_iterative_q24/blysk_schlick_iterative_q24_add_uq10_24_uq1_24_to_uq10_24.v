// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q24_add_uq10_24_uq1_24_to_uq10_24 (
    input  wire [33:0] a_i,  // UQ10.24
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    input  wire carry_i,
    output wire [33:0] s_o  // UQ10.24
);

  assign s_o = a_i + {9'b0, b_i} + {33'b0, carry_i};

endmodule

`default_nettype wire
