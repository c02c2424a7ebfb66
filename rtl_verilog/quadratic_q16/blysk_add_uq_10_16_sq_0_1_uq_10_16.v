// SPDX-License-Identifier: Apache-2.0
// add<uq<10, 16>, sq<0, 1>, uq<10, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_add_uq_10_16_sq_0_1_uq_10_16 (
    input  wire [25:0] a_i,
    input  wire signed [1:0] b_i,
    input  wire carry_i,
    output wire [25:0] s_o
);

  wire [16:0] shifted = {b_i, 15'b0};

  assign s_o = a_i + {{9{shifted[16]}}, shifted} + {25'b0, carry_i};

endmodule

`default_nettype wire
