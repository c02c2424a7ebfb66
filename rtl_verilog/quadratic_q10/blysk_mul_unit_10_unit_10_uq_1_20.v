// SPDX-License-Identifier: Apache-2.0
// mul<unit<10>, unit<10>, uq<1, 20>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_10_unit_10_uq_1_20 (
    input  wire [10:0] a_i,
    input  wire [10:0] b_i,
    output wire [20:0] p_o
);

  assign p_o = {10'b0, a_i} * {10'b0, b_i};

endmodule

`default_nettype wire
