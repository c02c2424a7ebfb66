// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q24, 24 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q24_add_sq21_24_sq11_24_to_sq21_24 (
    input  wire signed [45:0] a_i,  // SQ21.24
    input  wire signed [35:0] b_i,  // SQ11.24
    input  wire carry_i,
    output wire signed [45:0] s_o  // SQ21.24
);

  assign s_o = a_i + {{10{b_i[35]}}, b_i} + {45'b0, carry_i};

endmodule

`default_nettype wire
