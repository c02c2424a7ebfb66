// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
