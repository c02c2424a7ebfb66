// SPDX-License-Identifier: Apache-2.0
// add<sq<8, 30>, unit<10>, sq<8, 30>>, exported from the SystemC model.
`default_nettype none

module blysk_add_sq_8_30_unit_10_sq_8_30 (
    input  wire signed [38:0] a_i,
    input  wire [10:0] b_i,
    input  wire carry_i,
    output wire signed [38:0] s_o
);

  assign s_o = a_i + {8'b0, b_i, 20'b0} + {38'b0, carry_i};

endmodule

`default_nettype wire
