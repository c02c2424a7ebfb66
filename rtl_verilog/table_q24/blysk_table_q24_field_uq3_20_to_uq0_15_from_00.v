// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device table, format q24, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q24_field_uq3_20_to_uq0_15_from_00 (
    input  wire [22:0] a_i,  // UQ3.20
    output wire [14:0] y_o  // UQ0.15
);

  wire [7:0] unused_a_i_high = a_i[22:15];  // beyond the range of the result

  assign y_o = a_i[14:0] & 15'd32767;

endmodule

`default_nettype wire
