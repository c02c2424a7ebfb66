// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q12, 12 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q12_add_sq21_12_sq11_12_to_sq21_12 (
    input  wire signed [33:0] a_i,  // SQ21.12
    input  wire signed [23:0] b_i,  // SQ11.12
    input  wire carry_i,
    output wire signed [33:0] s_o  // SQ21.12
);

  assign s_o = a_i + {{10{b_i[23]}}, b_i} + {33'b0, carry_i};

endmodule

`default_nettype wire
