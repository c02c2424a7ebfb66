// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_constant_uq0_20 #(
    parameter [19:0] RAW = 20'd0
) (
    output wire [19:0] y_o  // UQ0.20
);

  assign y_o = RAW;

endmodule

`default_nettype wire
