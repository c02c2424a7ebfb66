// SPDX-License-Identifier: Apache-2.0
// Multiplier: p_o = a_i * b_i, rounded to nearest, ties up.
// device lyon, format q24, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q24_mul_uq1_27_uq1_27_to_uq1_24 (
    input  wire [27:0] a_i,  // UQ1.27, codes 0..134217728
    input  wire [27:0] b_i,  // UQ1.27, codes 0..134217728
    output wire [24:0] p_o  // UQ1.24, codes 0..16777216
);

  wire [54:0] product = a_i * b_i;
  wire [54:0] sum = product + 55'd536870912;
  wire [29:0] unused_sum_low = sum[29:0];  // below the last place of the result

  assign p_o = sum[54:30];

endmodule

`default_nettype wire
