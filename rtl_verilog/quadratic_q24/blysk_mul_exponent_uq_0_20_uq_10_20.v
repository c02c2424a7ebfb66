// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 20>, uq<10, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_20_uq_10_20 (
    input  wire [9:0] a_i,
    input  wire [19:0] b_i,
    output wire [29:0] p_o
);

  assign p_o = {20'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
