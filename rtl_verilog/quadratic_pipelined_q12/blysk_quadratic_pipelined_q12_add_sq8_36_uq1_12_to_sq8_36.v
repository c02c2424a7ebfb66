// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_add_sq8_36_uq1_12_to_sq8_36 (
    input  wire signed [44:0] a_i,  // SQ8.36
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    input  wire carry_i,
    output wire signed [44:0] s_o  // SQ8.36
);

  assign s_o = a_i + {8'b0, b_i, 24'b0} + {44'b0, carry_i};

endmodule

`default_nettype wire
