// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-interpolation, format q8, 8 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q8_add_sq11_8_sq0_8_to_sq11_8 (
    input  wire signed [19:0] a_i,  // SQ11.8
    input  wire signed [8:0] b_i,  // SQ0.8
    input  wire carry_i,
    output wire signed [19:0] s_o  // SQ11.8
);

  assign s_o = a_i + {{11{b_i[8]}}, b_i} + {19'b0, carry_i};

endmodule

`default_nettype wire
