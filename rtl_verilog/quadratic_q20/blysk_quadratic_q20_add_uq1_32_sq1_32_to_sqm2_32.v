// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_add_uq1_32_sq1_32_to_sqm2_32 (
    input  wire [32:0] a_i,  // UQ1.32
    input  wire signed [33:0] b_i,  // SQ1.32
    input  wire carry_i,
    output wire signed [30:0] s_o  // SQ-2.32
);

  wire [1:0] unused_a_i_high = a_i[32:31];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[33:31];  // beyond the range of the result

  assign s_o = a_i[30:0] + b_i[30:0] + {30'b0, carry_i};

endmodule

`default_nettype wire
