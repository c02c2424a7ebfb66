// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 36>, unit<12>, sq<8, 36>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_36_unit_12_sq_8_36 (
    input  wire signed [44:0] a_i,
    input  wire [12:0] b_i,
    input  wire carry_i,
    output wire signed [44:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 24'b0} + {44'b0, carry_i};

endmodule

`default_nettype wire
