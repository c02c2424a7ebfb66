// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_field_uq2_23_to_uq0_13_from_00 (
    input  wire [24:0] a_i,  // UQ2.23
    output wire [12:0] y_o  // UQ0.13
);

  wire [11:0] unused_a_i_high = a_i[24:13];  // beyond the range of the result

  assign y_o = a_i[12:0] & 13'd8191;

endmodule

`default_nettype wire
