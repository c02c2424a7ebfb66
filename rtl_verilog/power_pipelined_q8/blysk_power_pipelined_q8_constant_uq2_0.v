// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_constant_uq2_0 #(
    parameter [1:0] RAW = 2'd0
) (
    output wire [1:0] y_o  // UQ2.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
