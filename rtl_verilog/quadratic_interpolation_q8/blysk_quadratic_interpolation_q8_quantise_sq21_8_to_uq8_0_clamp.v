// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-interpolation, format q8, 8 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q8_quantise_sq21_8_to_uq8_0_clamp (
    input  wire signed [29:0] a_i,  // SQ21.8
    output wire [7:0] y_o  // UQ8.0
);

  wire [30:0] sum = {a_i[29], a_i} + 31'd128;
  wire [7:0] unused_sum_low = sum[7:0];  // below the last place of the result
  wire [22:0] shifted = sum[30:8];

  assign y_o = shifted[22] ? 8'd0 : ($signed(shifted) < 23'sd255) ? shifted[7:0] : 8'd255;

endmodule

`default_nettype wire
