// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 14>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_14 #(
    parameter [13:0] RAW = 14'd0
) (
    output wire [13:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
