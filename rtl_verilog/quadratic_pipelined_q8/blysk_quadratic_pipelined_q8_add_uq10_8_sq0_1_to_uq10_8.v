// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_add_uq10_8_sq0_1_to_uq10_8 (
    input  wire [17:0] a_i,  // UQ10.8
    input  wire signed [1:0] b_i,  // SQ0.1
    input  wire carry_i,
    output wire [17:0] s_o  // UQ10.8
);

  wire [8:0] shifted = {b_i, 7'b0};

  assign s_o = a_i + {{9{shifted[8]}}, shifted} + {17'b0, carry_i};

endmodule

`default_nettype wire
