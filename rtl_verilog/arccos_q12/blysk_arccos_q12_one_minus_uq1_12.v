// SPDX-License-Identifier: Apache-2.0
// Subtracter: y_o = 1 - a_i.
// device arccos, format q12, 18 digits of the root, table of 65 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q12_one_minus_uq1_12 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  assign y_o = 13'd4096 - a_i;

endmodule

`default_nettype wire
