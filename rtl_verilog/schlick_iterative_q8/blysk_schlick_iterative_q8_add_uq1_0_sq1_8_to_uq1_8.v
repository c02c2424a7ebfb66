// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q8_add_uq1_0_sq1_8_to_uq1_8 (
    input  wire a_i,  // UQ1.0
    input  wire signed [9:0] b_i,  // SQ1.8
    input  wire carry_i,
    output wire [8:0] s_o  // UQ1.8, codes 0..256
);

  wire unused_b_i_high = b_i[9];  // beyond the range of the result

  assign s_o = {a_i, 8'b0} + b_i[8:0] + {8'b0, carry_i};

endmodule

`default_nettype wire
