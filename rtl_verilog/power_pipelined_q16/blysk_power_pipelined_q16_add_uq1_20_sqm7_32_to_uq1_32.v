// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_add_uq1_20_sqm7_32_to_uq1_32 (
    input  wire [20:0] a_i,  // UQ1.20
    input  wire signed [25:0] b_i,  // SQ-7.32
    input  wire carry_i,
    output wire [32:0] s_o  // UQ1.32
);

  assign s_o = {a_i, 12'b0} + {{7{b_i[25]}}, b_i} + {32'b0, carry_i};

endmodule

`default_nettype wire
