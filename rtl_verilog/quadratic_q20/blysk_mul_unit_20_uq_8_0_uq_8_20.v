// SPDX-License-Identifier: Apache-2.0
// mul<unit<20>, uq<8, 0>, uq<8, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_20_uq_8_0_uq_8_20 (
    input  wire [20:0] a_i,
    input  wire [7:0] b_i,
    output wire [27:0] p_o
);

  assign p_o = {7'b0, a_i} * {20'b0, b_i};

endmodule

`default_nettype wire
