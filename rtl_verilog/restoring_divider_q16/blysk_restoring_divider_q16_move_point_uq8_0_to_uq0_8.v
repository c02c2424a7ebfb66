// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device restoring-divider, format q16, 24 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q16_move_point_uq8_0_to_uq0_8 (
    input  wire [7:0] a_i,  // UQ8.0
    output wire [7:0] y_o  // UQ0.8
);

  assign y_o = a_i;

endmodule

`default_nettype wire
