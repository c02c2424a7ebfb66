// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_add_uq2_0_sq2_23_to_uq1_23 (
    input  wire [1:0] a_i,  // UQ2.0
    input  wire signed [25:0] b_i,  // SQ2.23
    input  wire carry_i,
    output wire [23:0] s_o  // UQ1.23, codes 0..8388608
);

  wire unused_a_i_high = a_i[1];  // beyond the range of the result
  wire [1:0] unused_b_i_high = b_i[25:24];  // beyond the range of the result

  assign s_o = {a_i[0], 23'b0} + b_i[23:0] + {23'b0, carry_i};

endmodule

`default_nettype wire
