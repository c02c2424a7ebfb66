// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_20 #(
    parameter [19:0] RAW = 20'd0
) (
    output wire [19:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
