// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_add_uq4_0_uq1_28_to_uq4_28 (
    input  wire [3:0] a_i,  // UQ4.0
    input  wire [28:0] b_i,  // UQ1.28
    input  wire carry_i,
    output wire [31:0] s_o  // UQ4.28
);

  assign s_o = {a_i, 28'b0} + {3'b0, b_i} + {31'b0, carry_i};

endmodule

`default_nettype wire
