// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_add_uq1_12_sqm3_17_to_uq1_17 (
    input  wire [12:0] a_i,  // UQ1.12
    input  wire signed [14:0] b_i,  // SQ-3.17
    input  wire carry_i,
    output wire [17:0] s_o  // UQ1.17
);

  assign s_o = {a_i, 5'b0} + {{3{b_i[14]}}, b_i} + {17'b0, carry_i};

endmodule

`default_nettype wire
