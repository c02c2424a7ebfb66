// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 18>, uq<10, 18>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_18_uq_10_18 (
    input  wire [9:0] a_i,
    input  wire [17:0] b_i,
    output wire [27:0] p_o
);

  assign p_o = {18'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
