// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_mul_uq9_8_sq0_8_to_sq9_16 (
    input  wire [16:0] a_i,  // UQ9.8
    input  wire signed [8:0] b_i,  // SQ0.8
    output wire signed [25:0] p_o  // SQ9.16
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
