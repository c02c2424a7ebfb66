// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_add_sq8_40_uq1_14_to_sq8_40 (
    input  wire signed [48:0] a_i,  // SQ8.40
    input  wire [14:0] b_i,  // UQ1.14, codes 0..16384
    input  wire carry_i,
    output wire signed [48:0] s_o  // SQ8.40
);

  assign s_o = a_i + {8'b0, b_i, 26'b0} + {48'b0, carry_i};

endmodule

`default_nettype wire
