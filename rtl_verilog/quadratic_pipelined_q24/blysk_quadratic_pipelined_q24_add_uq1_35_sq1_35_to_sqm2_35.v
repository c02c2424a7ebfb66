// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_add_uq1_35_sq1_35_to_sqm2_35 (
    input  wire [35:0] a_i,  // UQ1.35
    input  wire signed [36:0] b_i,  // SQ1.35
    input  wire carry_i,
    output wire signed [33:0] s_o  // SQ-2.35
);

  wire [1:0] unused_a_i_high = a_i[35:34];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[36:34];  // beyond the range of the result

  assign s_o = a_i[33:0] + b_i[33:0] + {33'b0, carry_i};

endmodule

`default_nettype wire
