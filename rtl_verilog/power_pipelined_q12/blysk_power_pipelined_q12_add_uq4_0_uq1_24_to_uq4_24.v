// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_add_uq4_0_uq1_24_to_uq4_24 (
    input  wire [3:0] a_i,  // UQ4.0
    input  wire [24:0] b_i,  // UQ1.24
    input  wire carry_i,
    output wire [27:0] s_o  // UQ4.24
);

  assign s_o = {a_i, 24'b0} + {3'b0, b_i} + {27'b0, carry_i};

endmodule

`default_nettype wire
