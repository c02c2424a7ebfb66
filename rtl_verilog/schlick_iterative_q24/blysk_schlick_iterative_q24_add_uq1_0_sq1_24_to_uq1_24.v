// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q24_add_uq1_0_sq1_24_to_uq1_24 (
    input  wire a_i,  // UQ1.0
    input  wire signed [25:0] b_i,  // SQ1.24
    input  wire carry_i,
    output wire [24:0] s_o  // UQ1.24, codes 0..16777216
);

  wire unused_b_i_high = b_i[25];  // beyond the range of the result

  assign s_o = {a_i, 24'b0} + b_i[24:0] + {24'b0, carry_i};

endmodule

`default_nettype wire
