// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_add_sq10_24_sq8_24_to_sq10_24 (
    input  wire signed [34:0] a_i,  // SQ10.24
    input  wire signed [32:0] b_i,  // SQ8.24
    input  wire carry_i,
    output wire signed [34:0] s_o  // SQ10.24
);

  assign s_o = a_i + {{2{b_i[32]}}, b_i} + {34'b0, carry_i};

endmodule

`default_nettype wire
