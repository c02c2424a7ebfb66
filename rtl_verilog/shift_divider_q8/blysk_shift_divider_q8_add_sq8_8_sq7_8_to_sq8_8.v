// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device shift-divider, format q8, 8 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q8_add_sq8_8_sq7_8_to_sq8_8 (
    input  wire signed [16:0] a_i,  // SQ8.8
    input  wire signed [15:0] b_i,  // SQ7.8
    input  wire carry_i,
    output wire signed [16:0] s_o  // SQ8.8
);

  assign s_o = a_i + {b_i[15], b_i} + {16'b0, carry_i};

endmodule

`default_nettype wire
