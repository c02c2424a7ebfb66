// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_add_uq1_24_sq0_0_to_sq0_24 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire signed b_i,  // SQ0.0
    input  wire carry_i,
    output wire signed [24:0] s_o  // SQ0.24
);

  assign s_o = a_i + {b_i, 24'b0} + {24'b0, carry_i};

endmodule

`default_nettype wire
