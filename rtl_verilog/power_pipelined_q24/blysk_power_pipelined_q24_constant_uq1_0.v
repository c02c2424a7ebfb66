// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_constant_uq1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o  // UQ1.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
