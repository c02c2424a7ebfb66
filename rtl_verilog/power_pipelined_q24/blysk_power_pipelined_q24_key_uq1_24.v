// SPDX-License-Identifier: Apache-2.0
// Key block: y_o = a_i, or 0 while off_i is one.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_key_uq1_24 (
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire off_i,
    output wire [24:0] y_o  // UQ1.24, codes 0..16777216
);

  assign y_o = off_i ? 25'd0 : a_i;

endmodule

`default_nettype wire
