// SPDX-License-Identifier: Apache-2.0
// mul<unit<18>, unit<18>, uq<1, 30>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_18_unit_18_uq_1_30 (
    input  wire [18:0] a_i,
    input  wire [18:0] b_i,
    output wire [30:0] p_o
);

  wire [36:0] sum = {18'b0, a_i} * {18'b0, b_i} + 37'd32;
  wire [5:0] unused_sum_low = sum[5:0];  // below the last place of the result

  assign p_o = sum[36:6];

endmodule

`default_nettype wire
