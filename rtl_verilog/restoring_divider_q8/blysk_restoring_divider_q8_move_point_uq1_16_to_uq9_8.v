// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device restoring-divider, format q8, 16 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q8_move_point_uq1_16_to_uq9_8 (
    input  wire [16:0] a_i,  // UQ1.16
    output wire [16:0] y_o  // UQ9.8
);

  assign y_o = a_i;

endmodule

`default_nettype wire
