// SPDX-License-Identifier: Apache-2.0
// Constant: y_o = RAW, the integer on the wires.
// device quadratic-rom, format q16, memory of 1000 words of 26 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_rom_q16_constant_uq1_0 #(
    parameter RAW = 1'd0
) (
    output wire y_o  // UQ1.0
);

  assign y_o = RAW;

endmodule

`default_nettype wire
