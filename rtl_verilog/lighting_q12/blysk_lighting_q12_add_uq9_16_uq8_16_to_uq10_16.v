// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_add_uq9_16_uq8_16_to_uq10_16 (
    input  wire [24:0] a_i,  // UQ9.16
    input  wire [23:0] b_i,  // UQ8.16, codes 0..16711680
    input  wire carry_i,
    output wire [25:0] s_o  // UQ10.16
);

  assign s_o = {1'b0, a_i} + {2'b0, b_i} + {25'b0, carry_i};

endmodule

`default_nettype wire
