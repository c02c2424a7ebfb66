// SPDX-License-Identifier: Apache-2.0
// Key block: y_o = a_i, or 0 while off_i is one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_key_uq1_8 (
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire off_i,
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  assign y_o = off_i ? 9'd0 : a_i;

endmodule

`default_nettype wire
