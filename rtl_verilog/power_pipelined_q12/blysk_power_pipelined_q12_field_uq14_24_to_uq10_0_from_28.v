// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_field_uq14_24_to_uq10_0_from_28 (
    input  wire [37:0] a_i,  // UQ14.24
    output wire [9:0] y_o  // UQ10.0
);

  wire [27:0] unused_a_i_low = a_i[27:0];  // below the last place of the result

  assign y_o = a_i[37:28];

endmodule

`default_nettype wire
