// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device power, format q12, 16 lines for the logarithm, 32 for the power of two, exported from the SystemC model.
`default_nettype none

module blysk_power_q12_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
