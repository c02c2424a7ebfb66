// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 20>, sq<0, 1>, uq<10, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_20_sq_0_1_uq_10_20 (
    input  wire [29:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [29:0] s_o
);

  wire [20:0] shifted = {b_i, 19'b0};

  assign s_o = a_i + {{9{shifted[20]}}, shifted} + {29'b0, carry_i};

endmodule

`default_nettype wire
