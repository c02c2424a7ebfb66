// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q8_mul_uq1_8_uq1_8_to_uq1_16 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [16:0] p_o  // UQ1.16, codes 0..65536
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
