// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-interpolation, format q12, 12 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q12_quantise_sq21_12_to_uq8_0_clamp (
    input  wire signed [33:0] a_i,  // SQ21.12
    output wire [7:0] y_o  // UQ8.0
);

  wire [34:0] sum = {a_i[33], a_i} + 35'd2048;
  wire [11:0] unused_sum_low = sum[11:0];  // below the last place of the result
  wire [22:0] shifted = sum[34:12];

  assign y_o = shifted[22] ? 8'd0 : ($signed(shifted) < 23'sd255) ? shifted[7:0] : 8'd255;

endmodule

`default_nettype wire
