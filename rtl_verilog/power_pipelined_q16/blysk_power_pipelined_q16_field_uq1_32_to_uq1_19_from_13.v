// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_field_uq1_32_to_uq1_19_from_13 (
    input  wire [32:0] a_i,  // UQ1.32
    output wire [19:0] y_o  // UQ1.19
);

  wire [12:0] unused_a_i_low = a_i[12:0];  // below the last place of the result

  assign y_o = a_i[32:13];

endmodule

`default_nettype wire
