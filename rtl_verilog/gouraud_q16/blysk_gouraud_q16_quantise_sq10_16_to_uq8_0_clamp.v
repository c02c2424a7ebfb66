// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device gouraud, format q16, 16 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q16_quantise_sq10_16_to_uq8_0_clamp (
    input  wire signed [26:0] a_i,  // SQ10.16
    output wire [7:0] y_o  // UQ8.0
);

  wire [27:0] sum = {a_i[26], a_i} + 28'd32768;
  wire [15:0] unused_sum_low = sum[15:0];  // below the last place of the result
  wire [11:0] shifted = sum[27:16];

  assign y_o = shifted[11] ? 8'd0 : ($signed(shifted) < 12'sd255) ? shifted[7:0] : 8'd255;

endmodule

`default_nettype wire
