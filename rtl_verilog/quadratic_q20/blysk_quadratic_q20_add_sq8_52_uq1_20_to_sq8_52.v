// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic, format q20, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q20_add_sq8_52_uq1_20_to_sq8_52 (
    input  wire signed [60:0] a_i,  // SQ8.52
    input  wire [20:0] b_i,  // UQ1.20, codes 0..1048576
    input  wire carry_i,
    output wire signed [60:0] s_o  // SQ8.52
);

  assign s_o = a_i + {8'b0, b_i, 32'b0} + {60'b0, carry_i};

endmodule

`default_nettype wire
