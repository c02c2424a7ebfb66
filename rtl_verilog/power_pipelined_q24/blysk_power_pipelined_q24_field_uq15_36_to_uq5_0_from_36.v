// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_field_uq15_36_to_uq5_0_from_36 (
    input  wire [50:0] a_i,  // UQ15.36
    output wire [4:0] y_o  // UQ5.0
);

  wire [9:0] unused_a_i_high = a_i[50:41];  // beyond the range of the result
  wire [35:0] unused_a_i_low = a_i[35:0];  // below the last place of the result

  assign y_o = a_i[40:36] & 5'd31;

endmodule

`default_nettype wire
