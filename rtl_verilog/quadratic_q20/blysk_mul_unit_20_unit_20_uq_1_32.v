// SPDX-License-Identifier: Apache-2.0
// mul<unit<20>, unit<20>, uq<1, 32>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_20_unit_20_uq_1_32 (
    input  wire [20:0] a_i,
    input  wire [20:0] b_i,
    output wire [32:0] p_o
);

  wire [40:0] sum = {20'b0, a_i} * {20'b0, b_i} + 41'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result

  assign p_o = sum[40:8];

endmodule

`default_nettype wire
