// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_field_uq1_41_to_uq1_27_from_14 (
    input  wire [41:0] a_i,  // UQ1.41
    output wire [27:0] y_o  // UQ1.27
);

  wire [13:0] unused_a_i_low = a_i[13:0];  // below the last place of the result

  assign y_o = a_i[41:14];

endmodule

`default_nettype wire
