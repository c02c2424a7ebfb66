// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_field_uq2_18_to_uq1_17_from_01 (
    input  wire [19:0] a_i,  // UQ2.18
    output wire [17:0] y_o  // UQ1.17
);

  wire unused_a_i_high = a_i[19];  // beyond the range of the result
  wire unused_a_i_low = a_i[0];  // below the last place of the result

  assign y_o = a_i[18:1] & 18'd262143;

endmodule

`default_nettype wire
