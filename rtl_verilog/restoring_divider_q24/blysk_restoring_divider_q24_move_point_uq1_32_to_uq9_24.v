// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device restoring-divider, format q24, 32 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q24_move_point_uq1_32_to_uq9_24 (
    input  wire [32:0] a_i,  // UQ1.32
    output wire [32:0] y_o  // UQ9.24
);

  assign y_o = a_i;

endmodule

`default_nettype wire
