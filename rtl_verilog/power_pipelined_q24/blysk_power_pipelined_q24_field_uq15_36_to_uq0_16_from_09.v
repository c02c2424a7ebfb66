// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_field_uq15_36_to_uq0_16_from_09 (
    input  wire [50:0] a_i,  // UQ15.36
    output wire [15:0] y_o  // UQ0.16
);

  wire [25:0] unused_a_i_high = a_i[50:25];  // beyond the range of the result
  wire [8:0] unused_a_i_low = a_i[8:0];  // below the last place of the result

  assign y_o = a_i[24:9] & 16'd65535;

endmodule

`default_nettype wire
