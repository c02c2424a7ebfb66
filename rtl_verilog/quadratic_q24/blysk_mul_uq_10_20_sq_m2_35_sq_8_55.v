// SPDX-License-Identifier: Apache-2.0
// mul<uq<10, 20>, sq<-2, 35>, sq<8, 55>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_uq_10_20_sq_m2_35_sq_8_55 (
    input  wire [29:0] a_i,
    input  wire signed [33:0] b_i,
    output wire signed [63:0] p_o
);

  assign p_o = {34'b0, a_i} * {{30{b_i[33]}}, b_i};

endmodule

`default_nettype wire
