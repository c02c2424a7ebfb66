// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device restoring-divider, format q12, 20 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q12_move_point_uq1_20_to_uq9_12 (
    input  wire [20:0] a_i,  // UQ1.20
    output wire [20:0] y_o  // UQ9.12
);

  assign y_o = a_i;

endmodule

`default_nettype wire
