// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = a_i with as many fraction bits or more, exact.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_rescale_uq8_12_to_uq8_16 (
    input  wire [19:0] a_i,  // UQ8.12, codes 0..1044480
    output wire [23:0] y_o  // UQ8.16, codes 0..16711680
);

  assign y_o = {a_i, 4'b0};

endmodule

`default_nettype wire
