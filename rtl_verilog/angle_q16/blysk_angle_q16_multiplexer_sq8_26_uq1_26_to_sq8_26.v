// SPDX-License-Identifier: Apache-2.0
// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_multiplexer_sq8_26_uq1_26_to_sq8_26 (
    input  wire signed [34:0] a_i,  // SQ8.26
    input  wire [26:0] b_i,  // UQ1.26, codes 0..105414357
    input  wire select_b_i,
    output wire signed [34:0] y_o  // SQ8.26
);

  assign y_o = select_b_i ? {8'b0, b_i} : a_i;

endmodule

`default_nettype wire
