// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_add_uq1_11_sqm5_18_to_uq1_18 (
    input  wire [11:0] a_i,  // UQ1.11
    input  wire signed [13:0] b_i,  // SQ-5.18
    input  wire carry_i,
    output wire [18:0] s_o  // UQ1.18, codes 0..262144
);

  assign s_o = {a_i, 7'b0} + {{5{b_i[13]}}, b_i} + {18'b0, carry_i};

endmodule

`default_nettype wire
