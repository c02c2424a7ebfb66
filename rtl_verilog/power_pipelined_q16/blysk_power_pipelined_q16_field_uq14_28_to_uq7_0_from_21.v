// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_field_uq14_28_to_uq7_0_from_21 (
    input  wire [41:0] a_i,  // UQ14.28
    output wire [6:0] y_o  // UQ7.0
);

  wire [13:0] unused_a_i_high = a_i[41:28];  // beyond the range of the result
  wire [20:0] unused_a_i_low = a_i[20:0];  // below the last place of the result

  assign y_o = a_i[27:21] & 7'd127;

endmodule

`default_nettype wire
