// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_add_uq2_0_sq2_15_to_uq1_15 (
    input  wire [1:0] a_i,  // UQ2.0
    input  wire signed [17:0] b_i,  // SQ2.15
    input  wire carry_i,
    output wire [15:0] s_o  // UQ1.15, codes 0..32768
);

  wire unused_a_i_high = a_i[1];  // beyond the range of the result
  wire [1:0] unused_b_i_high = b_i[17:16];  // beyond the range of the result

  assign s_o = {a_i[0], 15'b0} + b_i[15:0] + {15'b0, carry_i};

endmodule

`default_nettype wire
