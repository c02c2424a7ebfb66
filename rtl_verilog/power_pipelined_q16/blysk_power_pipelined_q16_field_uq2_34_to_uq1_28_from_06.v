// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_field_uq2_34_to_uq1_28_from_06 (
    input  wire [35:0] a_i,  // UQ2.34
    output wire [28:0] y_o  // UQ1.28
);

  wire unused_a_i_high = a_i[35];  // beyond the range of the result
  wire [5:0] unused_a_i_low = a_i[5:0];  // below the last place of the result

  assign y_o = a_i[34:6] & 29'd536870911;

endmodule

`default_nettype wire
