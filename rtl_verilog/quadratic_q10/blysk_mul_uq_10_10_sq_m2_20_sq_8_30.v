// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 10>, sq<-2, 20>, sq<8, 30>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_10_sq_m2_20_sq_8_30 (
    input  wire [19:0] a_i,
    input  wire signed [18:0] b_i,
    output wire signed [38:0] p_o
);

  assign p_o = {19'b0, a_i} * {{20{b_i[18]}}, b_i};

endmodule

`default_nettype wire
