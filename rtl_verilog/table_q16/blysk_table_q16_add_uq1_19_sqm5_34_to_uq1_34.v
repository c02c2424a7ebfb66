// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_add_uq1_19_sqm5_34_to_uq1_34 (
    input  wire [19:0] a_i,  // UQ1.19
    input  wire signed [29:0] b_i,  // SQ-5.34
    input  wire carry_i,
    output wire [34:0] s_o  // UQ1.34, codes 0..17179869184
);

  assign s_o = {a_i, 15'b0} + {{5{b_i[29]}}, b_i} + {34'b0, carry_i};

endmodule

`default_nettype wire
