// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device gx-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q8_mul_uq9_1_uq1_16_to_uq9_17 (
    input  wire [9:0] a_i,  // UQ9.1
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [25:0] p_o  // UQ9.17
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
