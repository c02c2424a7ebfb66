// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q12_mul_uq1_12_uq1_12_to_uq1_24 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    input  wire [12:0] b_i,  // UQ1.12, codes 0..4096
    output wire [24:0] p_o  // UQ1.24, codes 0..16777216
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
