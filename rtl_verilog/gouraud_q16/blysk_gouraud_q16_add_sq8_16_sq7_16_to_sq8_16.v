// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gouraud, format q16, 16 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q16_add_sq8_16_sq7_16_to_sq8_16 (
    input  wire signed [24:0] a_i,  // SQ8.16
    input  wire signed [23:0] b_i,  // SQ7.16
    input  wire carry_i,
    output wire signed [24:0] s_o  // SQ8.16
);

  assign s_o = a_i + {b_i[23], b_i} + {24'b0, carry_i};

endmodule

`default_nettype wire
