// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic, format q18, coefficient derived, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_q18_constant_uq0_18 #(
    parameter [17:0] RAW = 18'd0
) (
    output wire [17:0] y_o  // UQ0.18
);

  assign y_o = RAW;

endmodule

`default_nettype wire
