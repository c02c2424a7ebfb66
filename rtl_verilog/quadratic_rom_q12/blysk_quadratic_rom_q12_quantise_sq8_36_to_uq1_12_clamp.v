// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-rom, format q12, memory of 1000 words of 22 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_rom_q12_quantise_sq8_36_to_uq1_12_clamp (
    input  wire signed [44:0] a_i,  // SQ8.36
    output wire [12:0] y_o  // UQ1.12, codes 0..4096
);

  wire [22:0] unused_a_i_low = a_i[22:0];  // below the last place of the result
  wire [21:0] shifted = a_i[44:23];
  wire [22:0] sum = {shifted[21], shifted} + 23'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result
  wire [21:0] shifted2 = sum[22:1];

  assign y_o = ($signed(shifted2) < 22'sd0) ? 13'd0 : ($signed(shifted2) > 22'sd4096) ? 13'd4096 : shifted2[12:0];

endmodule

`default_nettype wire
