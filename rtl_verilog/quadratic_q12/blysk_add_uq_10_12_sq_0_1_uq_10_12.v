// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 12>, sq<0, 1>, uq<10, 12>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_12_sq_0_1_uq_10_12 (
    input  wire [21:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [21:0] s_o
);

  wire [12:0] shifted = {b_i, 11'b0};

  assign s_o = a_i + {{9{shifted[12]}}, shifted} + {21'b0, carry_i};

endmodule

`default_nettype wire
