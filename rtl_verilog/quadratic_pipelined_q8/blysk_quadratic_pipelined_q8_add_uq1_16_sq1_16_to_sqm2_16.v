// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_add_uq1_16_sq1_16_to_sqm2_16 (
    input  wire [16:0] a_i,  // UQ1.16
    input  wire signed [17:0] b_i,  // SQ1.16
    input  wire carry_i,
    output wire signed [14:0] s_o  // SQ-2.16
);

  wire [1:0] unused_a_i_high = a_i[16:15];  // beyond the range of the result
  wire [2:0] unused_b_i_high = b_i[17:15];  // beyond the range of the result

  assign s_o = a_i[14:0] + b_i[14:0] + {14'b0, carry_i};

endmodule

`default_nettype wire
