// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device rational, format q24, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q24_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
