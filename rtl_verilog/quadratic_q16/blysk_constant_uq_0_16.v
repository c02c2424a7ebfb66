// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_16 #(
    parameter [15:0] RAW = 16'd0
) (
    output wire [15:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
