// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device shift-divider, format q12, 12 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q12_add_sq8_12_sq7_12_to_sq8_12 (
    input  wire signed [20:0] a_i,  // SQ8.12
    input  wire signed [19:0] b_i,  // SQ7.12
    input  wire carry_i,
    output wire signed [20:0] s_o  // SQ8.12
);

  assign s_o = a_i + {b_i[19], b_i} + {20'b0, carry_i};

endmodule

`default_nettype wire
