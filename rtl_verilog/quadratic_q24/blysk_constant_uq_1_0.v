// SPDX-License-Identifier: Apache-2.0
// constant<uq<1, 0>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_uq_1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
