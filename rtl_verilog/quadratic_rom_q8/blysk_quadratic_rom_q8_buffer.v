// SPDX-License-Identifier: Apache-2.0
// Wire: y_o = a_i.
// device quadratic-rom, format q8, memory of 1000 words of 18 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_rom_q8_buffer (
    input  wire a_i,
    output wire y_o
);

  assign y_o = a_i;

endmodule

`default_nettype wire
