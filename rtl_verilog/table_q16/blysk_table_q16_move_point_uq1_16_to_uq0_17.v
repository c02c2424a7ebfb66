// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device table, format q16, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q16_move_point_uq1_16_to_uq0_17 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    output wire [16:0] y_o  // UQ0.17
);

  assign y_o = a_i;

endmodule

`default_nettype wire
