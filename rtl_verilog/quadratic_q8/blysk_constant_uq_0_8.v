// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 8>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_8 #(
    parameter [7:0] RAW = 8'd0
) (
    output wire [7:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
