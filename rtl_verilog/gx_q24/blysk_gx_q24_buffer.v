// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device gx, format q24, a combinational divider, exported from the SystemC model.
`default_nettype none

module blysk_gx_q24_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
