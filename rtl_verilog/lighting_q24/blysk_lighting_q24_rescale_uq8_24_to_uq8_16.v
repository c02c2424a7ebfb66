// SPDX-License-Identifier: Apache-2.0
// y_o = a_i with fewer fraction bits, rounded to nearest, ties up.
// device lighting, format q24, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q24_rescale_uq8_24_to_uq8_16 (
    input  wire [31:0] a_i,  // UQ8.24, codes 0..4278190080
    output wire [23:0] y_o  // UQ8.16, codes 0..16711680
);

  wire [31:0] sum = a_i + 32'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result

  assign y_o = sum[31:8];

endmodule

`default_nettype wire
