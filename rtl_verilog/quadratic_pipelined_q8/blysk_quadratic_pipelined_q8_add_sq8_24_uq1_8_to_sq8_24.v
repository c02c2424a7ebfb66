// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_add_sq8_24_uq1_8_to_sq8_24 (
    input  wire signed [32:0] a_i,  // SQ8.24
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    input  wire carry_i,
    output wire signed [32:0] s_o  // SQ8.24
);

  assign s_o = a_i + {8'b0, b_i, 16'b0} + {32'b0, carry_i};

endmodule

`default_nettype wire
