// SPDX-License-Identifier: Apache-2.0
// The sign of a_i: negative_o = a_i < 0.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_sign_sq9_16 (
    input  wire signed [25:0] a_i,  // SQ9.16
    output wire negative_o
);

  wire [24:0] unused_a_i_low = a_i[24:0];  // below the last place of the result

  assign negative_o = a_i[25];

endmodule

`default_nettype wire
