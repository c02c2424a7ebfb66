// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_add_uq1_0_uq0_17_to_uq1_17 (
    input  wire a_i,  // UQ1.0
    input  wire [16:0] b_i,  // UQ0.17
    input  wire carry_i,
    output wire [17:0] s_o  // UQ1.17
);

  assign s_o = {a_i, 17'b0} + {1'b0, b_i} + {17'b0, carry_i};

endmodule

`default_nettype wire
