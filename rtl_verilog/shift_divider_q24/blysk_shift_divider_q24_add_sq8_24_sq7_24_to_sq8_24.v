// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device shift-divider, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q24_add_sq8_24_sq7_24_to_sq8_24 (
    input  wire signed [32:0] a_i,  // SQ8.24
    input  wire signed [31:0] b_i,  // SQ7.24
    input  wire carry_i,
    output wire signed [32:0] s_o  // SQ8.24
);

  assign s_o = a_i + {b_i[31], b_i} + {32'b0, carry_i};

endmodule

`default_nettype wire
