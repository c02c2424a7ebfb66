// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q8_mul_uq10_0_uq1_8_to_uq10_8 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [8:0] b_i,  // UQ1.8, codes 0..256
    output wire [17:0] p_o  // UQ10.8
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
