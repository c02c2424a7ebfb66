// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device gx-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q16_one_minus_uq1_28 (
    input  wire [28:0] a_i,  // UQ1.28, codes 0..268435456
    output wire [28:0] y_o  // UQ1.28, codes 0..268435456
);

  assign y_o = 29'd268435456 - a_i;

endmodule

`default_nettype wire
