// SPDX-License-Identifier: Apache-2.0
// Wires: y_o = the bits of a_i, with another binary point.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_move_point_uq10_0_to_uq9_1 (
    input  wire [9:0] a_i,  // UQ10.0, codes 1..1000
    output wire [9:0] y_o  // UQ9.1
);

  assign y_o = a_i;

endmodule

`default_nettype wire
