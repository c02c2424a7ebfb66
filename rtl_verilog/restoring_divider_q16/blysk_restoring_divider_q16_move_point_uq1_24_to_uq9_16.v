// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device restoring-divider, format q16, 24 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q16_move_point_uq1_24_to_uq9_16 (
    input  wire [24:0] a_i,  // UQ1.24
    output wire [24:0] y_o  // UQ9.16
);

  assign y_o = a_i;

endmodule

`default_nettype wire
