// SPDX-License-Identifier: Apache-2.0
// mul<unit<22>, unit<22>, uq<1, 34>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_22_unit_22_uq_1_34 (
    input  wire [22:0] a_i,
    input  wire [22:0] b_i,
    output wire [34:0] p_o
);

  wire [44:0] sum = {22'b0, a_i} * {22'b0, b_i} + 45'd512;
  wire [9:0] unused_sum_low = sum[9:0];  // below the last place of the result

  assign p_o = sum[44:10];

endmodule

`default_nettype wire
