// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 10>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_10 #(
    parameter [9:0] RAW = 10'd0
) (
    output wire [9:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
