// SPDX-License-Identifier: Apache-2.0
// Adder: s_o = a_i + b_i + carry_i, the carry weighing 1.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_add_sq9_48_uq1_0_to_sq9_48_unity_carry (
    input  wire signed [57:0] a_i,  // SQ9.48
    input  wire b_i,  // UQ1.0
    input  wire carry_i,
    output wire signed [57:0] s_o  // SQ9.48
);

  assign s_o = a_i + {9'b0, b_i, 48'b0} + {9'b0, carry_i, 48'b0};

endmodule

`default_nettype wire
