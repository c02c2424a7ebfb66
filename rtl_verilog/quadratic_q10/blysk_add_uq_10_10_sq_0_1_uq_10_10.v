// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 10>, sq<0, 1>, uq<10, 10>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_10_sq_0_1_uq_10_10 (
    input  wire [19:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [19:0] s_o
);

  wire [10:0] shifted = {b_i, 9'b0};

  assign s_o = a_i + {{9{shifted[10]}}, shifted} + {19'b0, carry_i};

endmodule

`default_nettype wire
