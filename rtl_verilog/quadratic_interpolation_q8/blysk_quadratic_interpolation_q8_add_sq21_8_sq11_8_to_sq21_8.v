// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q8, 8 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q8_add_sq21_8_sq11_8_to_sq21_8 (
    input  wire signed [29:0] a_i,  // SQ21.8
    input  wire signed [19:0] b_i,  // SQ11.8
    input  wire carry_i,
    output wire signed [29:0] s_o  // SQ21.8
);

  assign s_o = a_i + {{10{b_i[19]}}, b_i} + {29'b0, carry_i};

endmodule

`default_nettype wire
