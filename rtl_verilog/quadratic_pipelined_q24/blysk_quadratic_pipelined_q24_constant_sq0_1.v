// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_constant_sq0_1 #(
    parameter [1:0] RAW = 2'd0
) (
    output wire signed [1:0] y_o  // SQ0.1
);

  assign y_o = RAW;

endmodule

`default_nettype wire
