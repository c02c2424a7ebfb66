// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q22, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q22_add_uq1_34_sq1_34_to_sqm2_34 (
    input  wire [34:0] a_i,  // UQ1.34
    input  wire signed [35:0] b_i,  // SQ1.34
    input  wire carry_i,
    output wire signed [32:0] s_o  // SQ-2.34
);

  wire [1:0] unused_a_i_high = a_i[34:33];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[35:33];  // beyond the range of the result

  assign s_o = a_i[32:0] + b_i[32:0] + {32'b0, carry_i};

endmodule

`default_nettype wire
