// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device cosine-quadratic, format q16, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q16_mul_uq9_16_sq0_16_to_sq9_32 (
    input  wire [24:0] a_i,  // UQ9.16
    input  wire signed [16:0] b_i,  // SQ0.16
    output wire signed [41:0] p_o  // SQ9.32
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
