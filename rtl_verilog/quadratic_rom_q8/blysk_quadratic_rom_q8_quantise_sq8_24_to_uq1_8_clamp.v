// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-rom, format q8, memory of 1000 words of 18 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_rom_q8_quantise_sq8_24_to_uq1_8_clamp (
    input  wire signed [32:0] a_i,  // SQ8.24
    output wire [8:0] y_o  // UQ1.8, codes 0..256
);

  wire [14:0] unused_a_i_low = a_i[14:0];  // below the last place of the result
  wire [17:0] shifted = a_i[32:15];
  wire [18:0] sum = {shifted[17], shifted} + 19'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result
  wire [17:0] shifted2 = sum[18:1];

  assign y_o = ($signed(shifted2) < 18'sd0) ? 9'd0 : ($signed(shifted2) > 18'sd256) ? 9'd256 : shifted2[8:0];

endmodule

`default_nettype wire
