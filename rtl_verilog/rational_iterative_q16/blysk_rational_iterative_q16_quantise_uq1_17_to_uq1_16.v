// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_quantise_uq1_17_to_uq1_16 (
    input  wire [17:0] a_i,  // UQ1.17, codes 0..131072
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  wire [17:0] sum = a_i + 18'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result

  assign y_o = sum[17:1];

endmodule

`default_nettype wire
