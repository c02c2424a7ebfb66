// SPDX-License-Identifier: Apache-2.0
// mul<unit<14>, unit<14>, uq<1, 26>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_14_unit_14_uq_1_26 (
    input  wire [14:0] a_i,
    input  wire [14:0] b_i,
    output wire [26:0] p_o
);

  wire [28:0] sum = {14'b0, a_i} * {14'b0, b_i} + 29'd2;
  wire [1:0] unused_sum_low = sum[1:0];  // below the last place of the result

  assign p_o = sum[28:2];

endmodule

`default_nettype wire
