// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_add_uq1_30_sq1_30_to_sqm2_30 (
    input  wire [30:0] a_i,  // UQ1.30
    input  wire signed [31:0] b_i,  // SQ1.30
    input  wire carry_i,
    output wire signed [28:0] s_o  // SQ-2.30
);

  wire [1:0] unused_a_i_high = a_i[30:29];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[31:29];  // beyond the range of the result

  assign s_o = a_i[28:0] + b_i[28:0] + {28'b0, carry_i};

endmodule

`default_nettype wire
