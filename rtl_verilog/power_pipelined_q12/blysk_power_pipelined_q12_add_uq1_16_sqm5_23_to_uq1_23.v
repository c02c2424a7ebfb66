// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_add_uq1_16_sqm5_23_to_uq1_23 (
    input  wire [16:0] a_i,  // UQ1.16
    input  wire signed [18:0] b_i,  // SQ-5.23
    input  wire carry_i,
    output wire [23:0] s_o  // UQ1.23
);

  assign s_o = {a_i, 7'b0} + {{5{b_i[18]}}, b_i} + {23'b0, carry_i};

endmodule

`default_nettype wire
