// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_constant_uq1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o  // UQ1.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
