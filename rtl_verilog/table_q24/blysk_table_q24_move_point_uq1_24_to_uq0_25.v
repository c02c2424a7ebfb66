// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_move_point_uq1_24_to_uq0_25 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    output wire [24:0] y_o  // UQ0.25
);

  assign y_o = a_i;

endmodule

`default_nettype wire
