// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_add_uq1_0_uq0_13_to_uq1_13 (
    input  wire a_i,  // UQ1.0
    input  wire [12:0] b_i,  // UQ0.13
    input  wire carry_i,
    output wire [13:0] s_o  // UQ1.13
);

  assign s_o = {a_i, 13'b0} + {1'b0, b_i} + {13'b0, carry_i};

endmodule

`default_nettype wire
