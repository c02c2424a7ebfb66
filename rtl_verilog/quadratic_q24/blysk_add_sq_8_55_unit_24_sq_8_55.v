// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 55>, unit<24>, sq<8, 55>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_55_unit_24_sq_8_55 (
    input  wire signed [63:0] a_i,
    input  wire [24:0] b_i,
    input  wire carry_i,
    output wire signed [63:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 31'b0} + {63'b0, carry_i};

endmodule

`default_nettype wire
