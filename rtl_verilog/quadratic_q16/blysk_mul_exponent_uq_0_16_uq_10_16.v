// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 16>, uq<10, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_16_uq_10_16 (
    input  wire [9:0] a_i,
    input  wire [15:0] b_i,
    output wire [25:0] p_o
);

  assign p_o = {16'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
