// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 54>, unit<22>, sq<8, 54>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_54_unit_22_sq_8_54 (
    input  wire signed [62:0] a_i,
    input  wire [22:0] b_i,
    input  wire carry_i,
    output wire signed [62:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 32'b0} + {62'b0, carry_i};

endmodule

`default_nettype wire
