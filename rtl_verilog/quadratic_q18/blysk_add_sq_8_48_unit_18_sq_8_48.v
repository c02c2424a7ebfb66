// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 48>, unit<18>, sq<8, 48>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_48_unit_18_sq_8_48 (
    input  wire signed [56:0] a_i,
    input  wire [18:0] b_i,
    input  wire carry_i,
    output wire signed [56:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 30'b0} + {56'b0, carry_i};

endmodule

`default_nettype wire
