// SPDX-License-Identifier: Apache-2.0
// mul<exponent, uq<0, 8>, uq<10, 8>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_exponent_uq_0_8_uq_10_8 (
    input  wire [9:0] a_i,
    input  wire [7:0] b_i,
    output wire [17:0] p_o
);

  assign p_o = {8'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
