// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 14>, sq<0, 1>, uq<10, 14>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_14_sq_0_1_uq_10_14 (
    input  wire [23:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [23:0] s_o
);

  wire [14:0] shifted = {b_i, 13'b0};

  assign s_o = a_i + {{9{shifted[14]}}, shifted} + {23'b0, carry_i};

endmodule

`default_nettype wire
