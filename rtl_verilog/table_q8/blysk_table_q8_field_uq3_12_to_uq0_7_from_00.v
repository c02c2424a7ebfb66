// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device table, format q8, a memory of 256 lines, exported from the SystemC model.
`default_nettype none

module blysk_table_q8_field_uq3_12_to_uq0_7_from_00 (
    input  wire [14:0] a_i,  // UQ3.12
    output wire [6:0] y_o  // UQ0.7
);

  wire [7:0] unused_a_i_high = a_i[14:7];  // beyond the range of the result

  assign y_o = a_i[6:0] & 7'd127;

endmodule

`default_nettype wire
