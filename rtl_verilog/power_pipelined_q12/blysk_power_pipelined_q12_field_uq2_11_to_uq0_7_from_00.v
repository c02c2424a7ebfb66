// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_field_uq2_11_to_uq0_7_from_00 (
    input  wire [12:0] a_i,  // UQ2.11
    output wire [6:0] y_o  // UQ0.7
);

  wire [5:0] unused_a_i_high = a_i[12:7];  // beyond the range of the result

  assign y_o = a_i[6:0] & 7'd127;

endmodule

`default_nettype wire
