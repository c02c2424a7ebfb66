// SPDX-License-Identifier: Apache-2.0
// mul<unit<24>, unit<24>, uq<1, 35>>, exported from the SystemC model.
`default_nettype none

module blysk_mul_unit_24_unit_24_uq_1_35 (
    input  wire [24:0] a_i,
    input  wire [24:0] b_i,
    output wire [35:0] p_o
);

  wire [48:0] sum = {24'b0, a_i} * {24'b0, b_i} + 49'd4096;
  wire [12:0] unused_sum_low = sum[12:0];  // below the last place of the result

  assign p_o = sum[48:13];

endmodule

`default_nettype wire
