// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_add_uq1_28_sqm11_44_to_uq1_44 (
    input  wire [28:0] a_i,  // UQ1.28
    input  wire signed [33:0] b_i,  // SQ-11.44
    input  wire carry_i,
    output wire [44:0] s_o  // UQ1.44
);

  assign s_o = {a_i, 16'b0} + {{11{b_i[33]}}, b_i} + {44'b0, carry_i};

endmodule

`default_nettype wire
