// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic, format q14, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q14_constant_uq0_14 #(
    parameter [13:0] RAW = 14'd0
) (
    output wire [13:0] y_o  // UQ0.14
);

  assign y_o = RAW;

endmodule

`default_nettype wire
