// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = a_i with as many fraction bits or more, exact.
// device lighting, format q16, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q16_rescale_uq8_16 (
    input  wire [23:0] a_i,  // UQ8.16, codes 0..16711680
    output wire [23:0] y_o  // UQ8.16, codes 0..16711680
);

  assign y_o = a_i;

endmodule

`default_nettype wire
