// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_add_sq8_55_uq1_24_to_sq8_55 (
    input  wire signed [63:0] a_i,  // SQ8.55
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    input  wire carry_i,
    output wire signed [63:0] s_o  // SQ8.55
);

  assign s_o = a_i + {8'b0, b_i, 31'b0} + {63'b0, carry_i};

endmodule

`default_nettype wire
