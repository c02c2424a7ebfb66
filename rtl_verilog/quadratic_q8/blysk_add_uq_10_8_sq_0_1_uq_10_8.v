// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 8>, sq<0, 1>, uq<10, 8>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_8_sq_0_1_uq_10_8 (
    input  wire [17:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [17:0] s_o
);

  wire [8:0] shifted = {b_i, 7'b0};

  assign s_o = a_i + {{9{shifted[8]}}, shifted} + {17'b0, carry_i};

endmodule

`default_nettype wire
