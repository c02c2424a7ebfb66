// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device lyon, format q24, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q24_quantise_sq8_26_to_uq1_26_clamp (
    input  wire signed [34:0] a_i,  // SQ8.26
    output wire [26:0] y_o  // UQ1.26, codes 0..67108864
);

  assign y_o = a_i[34] ? 27'd0 : (a_i[34] || (a_i[33:26] == 8'd0)) ? a_i[26:0] : 27'd67108864;

endmodule

`default_nettype wire
