// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_mul_uq9_24_sq0_24_to_sq9_48 (
    input  wire [32:0] a_i,  // UQ9.24
    input  wire signed [24:0] b_i,  // SQ0.24
    output wire signed [57:0] p_o  // SQ9.48
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
