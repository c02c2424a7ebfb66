// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_quantise_uq10_16_to_uq8_16_clamp (
    input  wire [25:0] a_i,  // UQ10.16
    output wire [23:0] y_o  // UQ8.16, codes 0..16711680
);

  assign y_o = (a_i < 26'd16711680) ? a_i[23:0] : 24'd16711680;

endmodule

`default_nettype wire
