// SPDX-License-Identifier: Apache-2.0
// mul<unit<16>, uq<8, 0>, uq<8, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_16_uq_8_0_uq_8_16 (
    input  wire [16:0] a_i,
    input  wire [7:0] b_i,
    output wire [23:0] p_o
);

  assign p_o = {7'b0, a_i} * {16'b0, b_i};

endmodule

`default_nettype wire
