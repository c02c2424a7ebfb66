// SPDX-License-Identifier: Apache-2.0
// Gives a number its sign: y_o = -a_i while negative_i is one, else a_i.
// device restoring-divider, format q12, 20 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q12_with_sign_uq9_12_to_sq8_12 (
    input  wire [20:0] a_i,  // UQ9.12
    input  wire negative_i,
    output wire signed [20:0] y_o  // SQ8.12
);

  assign y_o = negative_i ? 21'd0 - a_i : a_i;

endmodule

`default_nettype wire
