// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i from one on, as many as y_o has.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_field_uq2_15_to_uq0_9_from_00 (
    input  wire [16:0] a_i,  // UQ2.15
    output wire [8:0] y_o  // UQ0.9
);

  wire [7:0] unused_a_i_high = a_i[16:9];  // beyond the range of the result

  assign y_o = a_i[8:0] & 9'd511;

endmodule

`default_nettype wire
