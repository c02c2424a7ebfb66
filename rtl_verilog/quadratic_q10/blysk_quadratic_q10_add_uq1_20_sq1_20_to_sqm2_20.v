// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_add_uq1_20_sq1_20_to_sqm2_20 (
    input  wire [20:0] a_i,  // UQ1.20
    input  wire signed [21:0] b_i,  // SQ1.20
    input  wire carry_i,
    output wire signed [18:0] s_o  // SQ-2.20
);

  wire [1:0] unused_a_i_high = a_i[20:19];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[21:19];  // beyond the range of the result

  assign s_o = a_i[18:0] + b_i[18:0] + {18'b0, carry_i};

endmodule

`default_nettype wire
