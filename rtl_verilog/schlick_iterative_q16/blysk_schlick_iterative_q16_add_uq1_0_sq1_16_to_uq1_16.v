// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device schlick-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q16_add_uq1_0_sq1_16_to_uq1_16 (
    input  wire a_i,  // UQ1.0
    input  wire signed [17:0] b_i,  // SQ1.16
    input  wire carry_i,
    output wire [16:0] s_o  // UQ1.16, codes 0..65536
);

  wire unused_b_i_high = b_i[17];  // beyond the range of the result

  assign s_o = {a_i, 16'b0} + b_i[16:0] + {16'b0, carry_i};

endmodule

`default_nettype wire
