// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_one_minus_uq1_36 (
    input  wire [36:0] a_i,  // UQ1.36, codes 0..68719476736
    output wire [36:0] y_o  // UQ1.36, codes 0..68719476736
);

  assign y_o = 37'd68719476736 - a_i;

endmodule

`default_nettype wire
