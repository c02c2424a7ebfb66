// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device power, format q24, 1024 lines for the logarithm, 2048 for the power of two, exported from the SystemC model.
`default_nettype none

module blysk_power_q24_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
