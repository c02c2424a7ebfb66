// SPDX-License-Identifier: Apache-2.0
// buffer, exported from the SystemC model.
`default_nettype none

module blysk_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
