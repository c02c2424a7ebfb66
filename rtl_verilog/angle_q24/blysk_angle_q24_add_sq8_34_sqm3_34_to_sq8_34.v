// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_add_sq8_34_sqm3_34_to_sq8_34 (
    input  wire signed [42:0] a_i,  // SQ8.34
    input  wire signed [31:0] b_i,  // SQ-3.34
    input  wire carry_i,
    output wire signed [42:0] s_o  // SQ8.34
);

  assign s_o = a_i + {{11{b_i[31]}}, b_i} + {42'b0, carry_i};

endmodule

`default_nettype wire
