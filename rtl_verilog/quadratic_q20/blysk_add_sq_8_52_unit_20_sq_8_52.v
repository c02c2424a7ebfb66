// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 52>, unit<20>, sq<8, 52>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_52_unit_20_sq_8_52 (
    input  wire signed [60:0] a_i,
    input  wire [20:0] b_i,
    input  wire carry_i,
    output wire signed [60:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 32'b0} + {60'b0, carry_i};

endmodule

`default_nettype wire
