// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_constant_uq1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o  // UQ1.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
