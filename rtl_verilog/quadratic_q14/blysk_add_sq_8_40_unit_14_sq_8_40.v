// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 40>, unit<14>, sq<8, 40>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_40_unit_14_sq_8_40 (
    input  wire signed [48:0] a_i,
    input  wire [14:0] b_i,
    input  wire carry_i,
    output wire signed [48:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 26'b0} + {48'b0, carry_i};

endmodule

`default_nettype wire
