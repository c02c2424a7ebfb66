// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic, format q10, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q10_constant_uq0_10 #(
    parameter [9:0] RAW = 10'd0
) (
    output wire [9:0] y_o  // UQ0.10
);

  assign y_o = RAW;

endmodule

`default_nettype wire
