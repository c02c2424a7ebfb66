// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 18>, sq<0, 1>, uq<10, 18>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_18_sq_0_1_uq_10_18 (
    input  wire [27:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [27:0] s_o
);

  wire [18:0] shifted = {b_i, 17'b0};

  assign s_o = a_i + {{9{shifted[18]}}, shifted} + {27'b0, carry_i};

endmodule

`default_nettype wire
