// SPDX-License-Identifier: Apache-2.0
// mul<unit<12>, uq<8, 0>, uq<8, 12>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_12_uq_8_0_uq_8_12 (
    input  wire [12:0] a_i,
    input  wire [7:0] b_i,
    output wire [19:0] p_o
);

  assign p_o = {7'b0, a_i} * {12'b0, b_i};

endmodule

`default_nettype wire
