// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_add_uq8_0_sq8_0_to_sq8_0 (
    input  wire [7:0] a_i,  // UQ8.0
    input  wire signed [8:0] b_i,  // SQ8.0
    input  wire carry_i,
    output wire signed [8:0] s_o  // SQ8.0, codes -255..255
);

  assign s_o = {1'b0, a_i} + b_i + {8'b0, carry_i};

endmodule

`default_nettype wire
