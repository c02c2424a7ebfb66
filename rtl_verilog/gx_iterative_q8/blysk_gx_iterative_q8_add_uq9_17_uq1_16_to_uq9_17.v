// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gx-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q8_add_uq9_17_uq1_16_to_uq9_17 (
    input  wire [25:0] a_i,  // UQ9.17
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    input  wire carry_i,
    output wire [25:0] s_o  // UQ9.17
);

  assign s_o = a_i + {8'b0, b_i, 1'b0} + {25'b0, carry_i};

endmodule

`default_nettype wire
