// SPDX-License-Identifier: Apache-2.0
// Rounds a_i to nearest, ties up, and clamps it to the codes of y_o.
// device lyon, format q8, degree 4, exported from the SystemC model.
`default_nettype none

module blysk_lyon_q8_quantise_sq8_10_to_uq1_10_clamp (
    input  wire signed [18:0] a_i,  // SQ8.10
    output wire [10:0] y_o  // UQ1.10, codes 0..1024
);

  assign y_o = a_i[18] ? 11'd0 : (a_i[18] || (a_i[17:10] == 8'd0)) ? a_i[10:0] : 11'd1024;

endmodule

`default_nettype wire
