// SPDX-License-Identifier: Apache-2.0
// Key block: y_o = a_i, or 0 while off_i is one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_key_uq1_12 (
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    input  wire off_i,
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  assign y_o = off_i ? 13'd0 : a_i;

endmodule

`default_nettype wire
