// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_move_point_uq1_8_to_uq0_9 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    output wire [8:0] y_o  // UQ0.9
);

  assign y_o = a_i;

endmodule

`default_nettype wire
