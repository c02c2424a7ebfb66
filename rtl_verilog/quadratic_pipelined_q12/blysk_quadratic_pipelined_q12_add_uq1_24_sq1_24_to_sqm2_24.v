// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_add_uq1_24_sq1_24_to_sqm2_24 (
    input  wire [24:0] a_i,  // UQ1.24
    input  wire signed [25:0] b_i,  // SQ1.24
    input  wire carry_i,
    output wire signed [22:0] s_o  // SQ-2.24
);

  wire [1:0] unused_a_i_high = a_i[24:23];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[25:23];  // beyond the range of the result

  assign s_o = a_i[22:0] + b_i[22:0] + {22'b0, carry_i};

endmodule

`default_nettype wire
