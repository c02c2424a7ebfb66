// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q24, 24 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q24_add_sq11_24_sq0_24_to_sq11_24 (
    input  wire signed [35:0] a_i,  // SQ11.24
    input  wire signed [24:0] b_i,  // SQ0.24
    input  wire carry_i,
    output wire signed [35:0] s_o  // SQ11.24
);

  assign s_o = a_i + {{11{b_i[24]}}, b_i} + {35'b0, carry_i};

endmodule

`default_nettype wire
