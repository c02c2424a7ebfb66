// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_add_uq1_15_sqm5_26_to_uq1_26 (
    input  wire [15:0] a_i,  // UQ1.15
    input  wire signed [21:0] b_i,  // SQ-5.26
    input  wire carry_i,
    output wire [26:0] s_o  // UQ1.26, codes 0..67108864
);

  assign s_o = {a_i, 11'b0} + {{5{b_i[21]}}, b_i} + {26'b0, carry_i};

endmodule

`default_nettype wire
