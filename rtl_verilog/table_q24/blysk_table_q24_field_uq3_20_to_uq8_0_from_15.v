// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_field_uq3_20_to_uq8_0_from_15 (
    input  wire [22:0] a_i,  // UQ3.20
    output wire [7:0] y_o  // UQ8.0
);

  wire [14:0] unused_a_i_low = a_i[14:0];  // below the last place of the result

  assign y_o = a_i[22:15];

endmodule

`default_nettype wire
