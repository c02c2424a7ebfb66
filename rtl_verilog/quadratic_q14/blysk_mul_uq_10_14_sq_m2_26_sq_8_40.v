// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 14>, sq<-2, 26>, sq<8, 40>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_14_sq_m2_26_sq_8_40 (
    input  wire [23:0] a_i,
    input  wire signed [24:0] b_i,
    output wire signed [48:0] p_o
);

  assign p_o = {25'b0, a_i} * {{24{b_i[24]}}, b_i};

endmodule

`default_nettype wire
