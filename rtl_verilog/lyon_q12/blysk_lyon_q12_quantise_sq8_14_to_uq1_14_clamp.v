// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device lyon, format q12, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q12_quantise_sq8_14_to_uq1_14_clamp (
    input  wire signed [22:0] a_i,  // SQ8.14
    output wire [14:0] y_o  // UQ1.14, codes 0..16384
);

  assign y_o = a_i[22] ? 15'd0 : (a_i[22] || (a_i[21:14] == 8'd0)) ? a_i[14:0] : 15'd16384;

endmodule

`default_nettype wire
