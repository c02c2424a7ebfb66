// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device power, format q8, 4 lines for the logarithm, 8 for the power of two, exported from the SystemC model.
`default_nettype none

module blysk_power_q8_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
