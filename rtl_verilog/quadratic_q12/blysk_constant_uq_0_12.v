// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 12>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_12 #(
    parameter [11:0] RAW = 12'd0
) (
    output wire [11:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
