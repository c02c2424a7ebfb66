// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gouraud, format q8, 8 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q8_add_sq10_8_sq8_8_to_sq10_8 (
    input  wire signed [18:0] a_i,  // SQ10.8
    input  wire signed [16:0] b_i,  // SQ8.8
    input  wire carry_i,
    output wire signed [18:0] s_o  // SQ10.8
);

  assign s_o = a_i + {{2{b_i[16]}}, b_i} + {18'b0, carry_i};

endmodule

`default_nettype wire
