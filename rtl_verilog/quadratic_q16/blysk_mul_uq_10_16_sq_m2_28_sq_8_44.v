// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 16>, sq<-2, 28>, sq<8, 44>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_16_sq_m2_28_sq_8_44 (
    input  wire [25:0] a_i,
    input  wire signed [26:0] b_i,
    output wire signed [52:0] p_o
);

  assign p_o = {27'b0, a_i} * {{26{b_i[26]}}, b_i};

endmodule

`default_nettype wire
