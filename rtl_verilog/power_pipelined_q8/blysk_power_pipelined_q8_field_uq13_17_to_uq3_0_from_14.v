// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_field_uq13_17_to_uq3_0_from_14 (
    input  wire [29:0] a_i,  // UQ13.17
    output wire [2:0] y_o  // UQ3.0
);

  wire [12:0] unused_a_i_high = a_i[29:17];  // beyond the range of the result
  wire [13:0] unused_a_i_low = a_i[13:0];  // below the last place of the result

  assign y_o = a_i[16:14] & 3'd7;

endmodule

`default_nettype wire
