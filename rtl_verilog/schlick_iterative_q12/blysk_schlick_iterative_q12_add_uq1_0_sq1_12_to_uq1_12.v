// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q12_add_uq1_0_sq1_12_to_uq1_12 (
    input  wire a_i,  // UQ1.0
    input  wire signed [13:0] b_i,  // SQ1.12
    input  wire carry_i,
    output wire [12:0] s_o  // UQ1.12, codes 0..4096
);

  wire unused_b_i_high = b_i[13];  // beyond the range of the result

  assign s_o = {a_i, 12'b0} + b_i[12:0] + {12'b0, carry_i};

endmodule

`default_nettype wire
