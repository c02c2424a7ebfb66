// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 44>, unit<16>, sq<8, 44>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_44_unit_16_sq_8_44 (
    input  wire signed [52:0] a_i,
    input  wire [16:0] b_i,
    input  wire carry_i,
    output wire signed [52:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 28'b0} + {52'b0, carry_i};

endmodule

`default_nettype wire
