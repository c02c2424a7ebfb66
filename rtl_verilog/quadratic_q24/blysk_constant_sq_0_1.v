// SPDX-License-Identifier: Apache-2.0
// constant<sq<0, 1>>, exported from the SystemC model.
`default_nettype none

module blysk_constant_sq_0_1 #(
    parameter [1:0] RAW = 2'd0
) (
    output wire signed [1:0] y_o
);

  assign y_o = RAW;

endmodule

`default_nettype wire
