// SPDX-License-Identifier: Apache-2.0
// OR gate: y_o = one, if b_i or any bit of a_i is.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_either_uq10_0 (
    input  wire [9:0] a_i,  // UQ10.0
    input  wire b_i,
    output wire y_o
);

  assign y_o = !(a_i == 10'd0) || b_i;

endmodule

`default_nettype wire
