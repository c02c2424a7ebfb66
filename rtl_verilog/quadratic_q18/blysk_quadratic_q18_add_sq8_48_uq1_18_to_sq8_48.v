// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_add_sq8_48_uq1_18_to_sq8_48 (
    input  wire signed [56:0] a_i,  // SQ8.48
    input  wire [18:0] b_i,  // UQ1.18, codes 0..262144
    input  wire carry_i,
    output wire signed [56:0] s_o  // SQ8.48
);

  assign s_o = a_i + {8'b0, b_i, 30'b0} + {56'b0, carry_i};

endmodule

`default_nettype wire
