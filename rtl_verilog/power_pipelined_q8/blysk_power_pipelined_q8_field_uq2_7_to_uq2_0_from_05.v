// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_field_uq2_7_to_uq2_0_from_05 (
    input  wire [8:0] a_i,  // UQ2.7
    output wire [1:0] y_o  // UQ2.0
);

  wire [1:0] unused_a_i_high = a_i[8:7];  // beyond the range of the result
  wire [4:0] unused_a_i_low = a_i[4:0];  // below the last place of the result

  assign y_o = a_i[6:5] & 2'd3;

endmodule

`default_nettype wire
