// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device angle, format q12, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q12_add_sq8_22_sqm3_22_to_sq8_22 (
    input  wire signed [30:0] a_i,  // SQ8.22
    input  wire signed [19:0] b_i,  // SQ-3.22
    input  wire carry_i,
    output wire signed [30:0] s_o  // SQ8.22
);

  assign s_o = a_i + {{11{b_i[19]}}, b_i} + {30'b0, carry_i};

endmodule

`default_nettype wire
