// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 20>, sq<-2, 32>, sq<8, 52>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_20_sq_m2_32_sq_8_52 (
    input  wire [29:0] a_i,
    input  wire signed [30:0] b_i,
    output wire signed [60:0] p_o
);

  assign p_o = {31'b0, a_i} * {{30{b_i[30]}}, b_i};

endmodule

`default_nettype wire
