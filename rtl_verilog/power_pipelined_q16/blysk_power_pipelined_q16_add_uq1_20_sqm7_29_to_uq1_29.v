// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_add_uq1_20_sqm7_29_to_uq1_29 (
    input  wire [20:0] a_i,  // UQ1.20
    input  wire signed [22:0] b_i,  // SQ-7.29
    input  wire carry_i,
    output wire [29:0] s_o  // UQ1.29
);

  assign s_o = {a_i, 9'b0} + {{7{b_i[22]}}, b_i} + {29'b0, carry_i};

endmodule

`default_nettype wire
