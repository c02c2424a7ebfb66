// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q16_add_uq10_16_uq1_16_to_uq10_16 (
    input  wire [25:0] a_i,  // UQ10.16
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    input  wire carry_i,
    output wire [25:0] s_o  // UQ10.16
);

  assign s_o = a_i + {9'b0, b_i} + {25'b0, carry_i};

endmodule

`default_nettype wire
