// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_field_uq2_26_to_uq1_24_from_02 (
    input  wire [27:0] a_i,  // UQ2.26
    output wire [24:0] y_o  // UQ1.24
);

  wire unused_a_i_high = a_i[27];  // beyond the range of the result
  wire [1:0] unused_a_i_low = a_i[1:0];  // below the last place of the result

  assign y_o = a_i[26:2] & 25'd33554431;

endmodule

`default_nettype wire
