// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_add_sq8_26_sqm3_26_to_sq8_26 (
    input  wire signed [34:0] a_i,  // SQ8.26
    input  wire signed [23:0] b_i,  // SQ-3.26
    input  wire carry_i,
    output wire signed [34:0] s_o  // SQ8.26
);

  assign s_o = a_i + {{11{b_i[23]}}, b_i} + {34'b0, carry_i};

endmodule

`default_nettype wire
