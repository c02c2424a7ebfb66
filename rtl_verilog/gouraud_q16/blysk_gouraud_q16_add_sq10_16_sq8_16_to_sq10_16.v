// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gouraud, format q16, 16 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q16_add_sq10_16_sq8_16_to_sq10_16 (
    input  wire signed [26:0] a_i,  // SQ10.16
    input  wire signed [24:0] b_i,  // SQ8.16
    input  wire carry_i,
    output wire signed [26:0] s_o  // SQ10.16
);

  assign s_o = a_i + {{2{b_i[24]}}, b_i} + {26'b0, carry_i};

endmodule

`default_nettype wire
