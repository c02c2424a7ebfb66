// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry being one ulp of s_o.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_add_uq1_8_sq0_0_to_sq0_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire signed b_i,  // SQ0.0
    input  wire carry_i,
    output wire signed [8:0] s_o  // SQ0.8
);

  assign s_o = a_i + {b_i, 8'b0} + {8'b0, carry_i};

endmodule

`default_nettype wire
