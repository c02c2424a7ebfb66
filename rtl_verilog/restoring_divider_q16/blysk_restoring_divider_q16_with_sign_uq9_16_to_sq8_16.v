// SPDX-License-Identifier: Apache-2.0
// Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.
// device restoring-divider, format q16, 24 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q16_with_sign_uq9_16_to_sq8_16 (
    input  wire [24:0] a_i,  // UQ9.16
    input  wire negative_i,
    output wire signed [24:0] y_o  // SQ8.16
);

  assign y_o = negative_i ? 25'd0 - a_i : a_i;

endmodule

`default_nettype wire
