// SPDX-License-Identifier: Apache-2.0
// mul<unit<22>, uq<8, 0>, uq<8, 22>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_22_uq_8_0_uq_8_22 (
    input  wire [22:0] a_i,
    input  wire [7:0] b_i,
    output wire [29:0] p_o
);

  assign p_o = {7'b0, a_i} * {22'b0, b_i};

endmodule

`default_nettype wire
