// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device gx, format q8, a combinational divider, exported from the SystemC model.
`default_nettype none

module blysk_gx_q8_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
