// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_add_uq1_26_sq1_26_to_sqm2_26 (
    input  wire [26:0] a_i,  // UQ1.26
    input  wire signed [27:0] b_i,  // SQ1.26
    input  wire carry_i,
    output wire signed [24:0] s_o  // SQ-2.26
);

  wire [1:0] unused_a_i_high = a_i[26:25];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[27:25];  // beyond the range of the result

  assign s_o = a_i[24:0] + b_i[24:0] + {24'b0, carry_i};

endmodule

`default_nettype wire
