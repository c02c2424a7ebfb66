// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_field_uq1_20_to_uq1_11_from_09 (
    input  wire [20:0] a_i,  // UQ1.20
    output wire [11:0] y_o  // UQ1.11
);

  wire [8:0] unused_a_i_low = a_i[8:0];  // below the last place of the result

  assign y_o = a_i[20:9];

endmodule

`default_nettype wire
