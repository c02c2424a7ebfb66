// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device lighting, format q8, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q8_mul_uq8_8_uq1_8_to_uq8_16 (
    input  wire [15:0] a_i,  // UQ8.8, codes 0..65280
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [23:0] p_o  // UQ8.16, codes 0..16711680
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
