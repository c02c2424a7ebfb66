// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_add_uq5_0_uq1_36_to_uq5_36 (
    input  wire [4:0] a_i,  // UQ5.0
    input  wire [36:0] b_i,  // UQ1.36
    input  wire carry_i,
    output wire [40:0] s_o  // UQ5.36
);

  assign s_o = {a_i, 36'b0} + {4'b0, b_i} + {40'b0, carry_i};

endmodule

`default_nettype wire
