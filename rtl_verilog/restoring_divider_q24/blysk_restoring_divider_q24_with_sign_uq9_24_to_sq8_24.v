// SPDX-License-Identifier: Apache-2.0
// Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.
// device restoring-divider, format q24, 32 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q24_with_sign_uq9_24_to_sq8_24 (
    input  wire [32:0] a_i,  // UQ9.24
    input  wire negative_i,
    output wire signed [32:0] y_o  // SQ8.24
);

  assign y_o = negative_i ? 33'd0 - a_i : a_i;

endmodule

`default_nettype wire
