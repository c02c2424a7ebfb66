// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, exact.
// device schlick-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q16_mul_uq10_0_uq1_16_to_uq10_16 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    input  wire [16:0] b_i,  // UQ1.16, codes 0..65536
    output wire [25:0] p_o  // UQ10.16
);

  assign p_o = a_i * b_i;

endmodule

`default_nettype wire
