// SPDX-License-Identifier: Apache-2.0
// mul<unit<8>, unit<8>, uq<1, 16>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_8_unit_8_uq_1_16 (
    input  wire [8:0] a_i,
    input  wire [8:0] b_i,
    output wire [16:0] p_o
);

  assign p_o = {8'b0, a_i} * {8'b0, b_i};

endmodule

`default_nettype wire
