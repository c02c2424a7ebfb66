// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device cosine-quadratic, format q8, gated by the sign of adder 8, constants weigh unity, exported from the SystemC model.
`default_nettype none

module blysk_cosine_quadratic_q8_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
