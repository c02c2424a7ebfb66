// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 8>, sq<-2, 16>, sq<8, 24>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_8_sq_m2_16_sq_8_24 (
    input  wire [17:0] a_i,
    input  wire signed [14:0] b_i,
    output wire signed [32:0] p_o
);

  assign p_o = {15'b0, a_i} * {{18{b_i[14]}}, b_i};

endmodule

`default_nettype wire
