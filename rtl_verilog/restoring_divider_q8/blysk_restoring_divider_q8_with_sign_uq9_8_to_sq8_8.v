// SPDX-License-Identifier: Apache-2.0
// Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.
// device restoring-divider, format q8, 16 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q8_with_sign_uq9_8_to_sq8_8 (
    input  wire [16:0] a_i,  // UQ9.8
    input  wire negative_i,
    output wire signed [16:0] y_o  // SQ8.8
);

  assign y_o = negative_i ? 17'd0 - a_i : a_i;

endmodule

`default_nettype wire
