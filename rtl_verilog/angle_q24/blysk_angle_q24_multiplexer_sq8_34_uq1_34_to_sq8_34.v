// SPDX-License-Identifier: Apache-2.0
// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_multiplexer_sq8_34_uq1_34_to_sq8_34 (
    input  wire signed [42:0] a_i,  // SQ8.34
    input  wire [34:0] b_i,  // UQ1.34, codes 0..26986075409
    input  wire select_b_i,
    output wire signed [42:0] y_o  // SQ8.34
);

  assign y_o = select_b_i ? {8'b0, b_i} : a_i;

endmodule

`default_nettype wire
