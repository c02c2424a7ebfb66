// SPDX-License-Identifier: Apache-2.0
// Key block: y_o = a_i, or 0 while off_i is one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_key_uq1_16 (
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire off_i,
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  assign y_o = off_i ? 17'd0 : a_i;

endmodule

`default_nettype wire
