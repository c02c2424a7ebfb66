// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device lyon, format q16, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q16_quantise_sq8_18_to_uq1_18_clamp (
    input  wire signed [26:0] a_i,  // SQ8.18
    output wire [18:0] y_o  // UQ1.18, codes 0..262144
);

  assign y_o = a_i[26] ? 19'd0 : (a_i[26] || (a_i[25:18] == 8'd0)) ? a_i[18:0] : 19'd262144;

endmodule

`default_nettype wire
