// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_add_uq1_28_sq1_28_to_sqm2_28 (
    input  wire [28:0] a_i,  // UQ1.28
    input  wire signed [29:0] b_i,  // SQ1.28
    input  wire carry_i,
    output wire signed [26:0] s_o  // SQ-2.28
);

  wire [1:0] unused_a_i_high = a_i[28:27];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[29:27];  // beyond the range of the result

  assign s_o = a_i[26:0] + b_i[26:0] + {26'b0, carry_i};

endmodule

`default_nettype wire
