// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_field_uq2_11_to_uq4_0_from_07 (
    input  wire [12:0] a_i,  // UQ2.11
    output wire [3:0] y_o  // UQ4.0
);

  wire [1:0] unused_a_i_high = a_i[12:11];  // beyond the range of the result
  wire [6:0] unused_a_i_low = a_i[6:0];  // below the last place of the result

  assign y_o = a_i[10:7] & 4'd15;

endmodule

`default_nettype wire
