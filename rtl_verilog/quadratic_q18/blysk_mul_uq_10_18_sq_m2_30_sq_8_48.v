// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 18>, sq<-2, 30>, sq<8, 48>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_18_sq_m2_30_sq_8_48 (
    input  wire [27:0] a_i,
    input  wire signed [28:0] b_i,
    output wire signed [56:0] p_o
);

  assign p_o = {29'b0, a_i} * {{28{b_i[28]}}, b_i};

endmodule

`default_nettype wire
