// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device cosine-quadratic, format q12, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q12_mul_uq9_12_sq0_12_to_sq9_24 (
    input  wire [20:0] a_i,  // UQ9.12
    input  wire signed [12:0] b_i,  // SQ0.12
    output wire signed [33:0] p_o  // SQ9.24
);

  assign p_o = $signed({1'b0, a_i}) * b_i;

endmodule

`default_nettype wire
