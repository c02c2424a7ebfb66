// SPDX-License-Identifier: Apache-2.0
// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_multiplexer_uq8_16_uq8_16_to_uq8_16 (
    input  wire [23:0] a_i,  // UQ8.16, codes 0..16711680
    input  wire [23:0] b_i,  // UQ8.16, codes 0..16711680
    input  wire select_b_i,
    output wire [23:0] y_o  // UQ8.16, codes 0..16711680
);

  assign y_o = select_b_i ? b_i : a_i;

endmodule

`default_nettype wire
