// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
