// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_add_sq8_44_uq1_16_to_sq8_44 (
    input  wire signed [52:0] a_i,  // SQ8.44
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    input  wire carry_i,
    output wire signed [52:0] s_o  // SQ8.44
);

  assign s_o = a_i + {8'b0, b_i, 28'b0} + {52'b0, carry_i};

endmodule

`default_nettype wire
