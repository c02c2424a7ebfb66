// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q16, 16 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q16_add_sq21_16_sq11_16_to_sq21_16 (
    input  wire signed [37:0] a_i,  // SQ21.16
    input  wire signed [27:0] b_i,  // SQ11.16
    input  wire carry_i,
    output wire signed [37:0] s_o  // SQ21.16
);

  assign s_o = a_i + {{10{b_i[27]}}, b_i} + {37'b0, carry_i};

endmodule

`default_nettype wire
