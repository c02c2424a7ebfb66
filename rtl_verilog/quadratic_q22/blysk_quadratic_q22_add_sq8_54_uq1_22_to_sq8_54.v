// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_add_sq8_54_uq1_22_to_sq8_54 (
    input  wire signed [62:0] a_i,  // SQ8.54
    input  wire [22:0] b_i,  // UQ1.22, codes 0..4194304
    input  wire carry_i,
    output wire signed [62:0] s_o  // SQ8.54
);

  assign s_o = a_i + {8'b0, b_i, 32'b0} + {62'b0, carry_i};

endmodule

`default_nettype wire
