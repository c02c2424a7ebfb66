// SPDX-License-Identifier: Apache-2.0
// The sign of a_i: negative_o = a_i < 0.
// device cosine-quadratic, format q24, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q24_sign_sq9_48 (
    input  wire signed [57:0] a_i,  // SQ9.48
    output wire negative_o
);

  wire [56:0] unused_a_i_low = a_i[56:0];  // below the last place of the result

  assign negative_o = a_i[57];

endmodule

`default_nettype wire
