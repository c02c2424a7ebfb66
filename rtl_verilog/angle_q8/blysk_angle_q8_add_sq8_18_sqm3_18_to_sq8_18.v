// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_add_sq8_18_sqm3_18_to_sq8_18 (
    input  wire signed [26:0] a_i,  // SQ8.18
    input  wire signed [15:0] b_i,  // SQ-3.18
    input  wire carry_i,
    output wire signed [26:0] s_o  // SQ8.18
);

  assign s_o = a_i + {{11{b_i[15]}}, b_i} + {26'b0, carry_i};

endmodule

`default_nettype wire
