// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q8_add_uq10_8_uq1_8_to_uq10_8 (
    input  wire [17:0] a_i,  // UQ10.8
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    input  wire carry_i,
    output wire [17:0] s_o  // UQ10.8
);

  assign s_o = a_i + {9'b0, b_i} + {17'b0, carry_i};

endmodule

`default_nettype wire
