// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device quadratic-rom, format q16, memory of 1000 words of 26 bits, coefficient exact, BRDF clamped to [0, 1], exported from the SystemC model.
`default_nettype none

module blysk_quadratic_rom_q16_quantise_sq8_44_to_uq1_16_clamp (
    input  wire signed [52:0] a_i,  // SQ8.44
    output wire [16:0] y_o  // UQ1.16, codes 0..65536
);

  wire [26:0] unused_a_i_low = a_i[26:0];  // below the last place of the result
  wire [25:0] shifted = a_i[52:27];
  wire [26:0] sum = {shifted[25], shifted} + 27'd1;
  wire unused_sum_low = sum[0];  // below the last place of the result
  wire [25:0] shifted2 = sum[26:1];

  assign y_o = ($signed(shifted2) < 26'sd0) ? 17'd0 : ($signed(shifted2) > 26'sd65536) ? 17'd65536 : shifted2[16:0];

endmodule

`default_nettype wire
