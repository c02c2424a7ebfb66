// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_add_sq8_30_uq1_10_to_sq8_30 (
    input  wire signed [38:0] a_i,  // SQ8.30
    input  wire [10:0] b_i,  // UQ1.10, codes 0..1024
    input  wire carry_i,
    output wire signed [38:0] s_o  // SQ8.30
);

  assign s_o = a_i + {8'b0, b_i, 20'b0} + {38'b0, carry_i};

endmodule

`default_nettype wire
