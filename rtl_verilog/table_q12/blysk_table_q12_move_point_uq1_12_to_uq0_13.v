// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device table, format q12, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q12_move_point_uq1_12_to_uq0_13 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire [12:0] y_o  // UQ0.13
);

  assign y_o = a_i;

endmodule

`default_nettype wire
