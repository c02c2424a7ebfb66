// SPDX-License-Identifier: Apache-2.0
// constant<uq<0, 18>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_0_18 #(
    parameter [17:0] RAW = 18'd0
) (
    output wire [17:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
