// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 12>, sq<-2, 24>, sq<8, 36>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_12_sq_m2_24_sq_8_36 (
    input  wire [21:0] a_i,
    input  wire signed [22:0] b_i,
    output wire signed [44:0] p_o
);

  assign p_o = {23'b0, a_i} * {{22{b_i[22]}}, b_i};

endmodule

`default_nettype wire
