// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device lyon, format q8, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q8_mul_uq8_2_uq1_8_to_uq8_10 (
    input  wire [9:0] a_i,  // UQ8.2
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [17:0] p_o  // UQ8.10
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
