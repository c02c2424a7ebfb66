// SPDX-License-Identifier: Apache-2.0
// mul<unit<12>, unit<12>, uq<1, 24>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_12_unit_12_uq_1_24 (
    input  wire [12:0] a_i,
    input  wire [12:0] b_i,
    output wire [24:0] p_o
);

  assign p_o = {12'b0, a_i} * {12'b0, b_i};

endmodule

`default_nettype wire
