// SPDX-License-Identifier: Apache-2.0
// mul<unit<16>, unit<16>, uq<1, 28>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_16_unit_16_uq_1_28 (
    input  wire [16:0] a_i,
    input  wire [16:0] b_i,
    output wire [28:0] p_o
);

  wire [32:0] sum = {16'b0, a_i} * {16'b0, b_i} + 33'd8;
  wire [3:0] unused_sum_low = sum[3:0];  // below the last place of the result

  assign p_o = sum[32:4];

endmodule

`default_nettype wire
