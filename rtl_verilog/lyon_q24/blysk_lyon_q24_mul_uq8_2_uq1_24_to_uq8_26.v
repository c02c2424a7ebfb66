// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device lyon, format q24, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q24_mul_uq8_2_uq1_24_to_uq8_26 (
    input  wire [9:0] a_i,  // UQ8.2
    input  wire [24:0] b_i,  // UQ1.24, codes 0..16777216
    output wire [33:0] p_o  // UQ8.26
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
