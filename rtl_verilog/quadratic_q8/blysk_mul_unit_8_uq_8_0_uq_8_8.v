// SPDX-License-Identifier: Apache-2.0
// mul<unit<8>, uq<8, 0>, uq<8, 8>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_8_uq_8_0_uq_8_8 (
    input  wire [8:0] a_i,
    input  wire [7:0] b_i,
    output wire [15:0] p_o
);

  assign p_o = {7'b0, a_i} * {8'b0, b_i};

endmodule

`default_nettype wire
