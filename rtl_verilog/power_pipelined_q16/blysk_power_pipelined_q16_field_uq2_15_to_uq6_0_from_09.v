// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_field_uq2_15_to_uq6_0_from_09 (
    input  wire [16:0] a_i,  // UQ2.15
    output wire [5:0] y_o  // UQ6.0
);

  wire [1:0] unused_a_i_high = a_i[16:15];  // beyond the range of the result
  wire [8:0] unused_a_i_low = a_i[8:0];  // below the last place of the result

  assign y_o = a_i[14:9] & 6'd63;

endmodule

`default_nettype wire
