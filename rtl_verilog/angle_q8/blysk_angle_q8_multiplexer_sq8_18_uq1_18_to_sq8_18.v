// SPDX-License-Identifier: Apache-2.0
// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_multiplexer_sq8_18_uq1_18_to_sq8_18 (
    input  wire signed [26:0] a_i,  // SQ8.18
    input  wire [18:0] b_i,  // UQ1.18, codes 0..411774
    input  wire select_b_i,
    output wire signed [26:0] y_o  // SQ8.18
);

  assign y_o = select_b_i ? {8'b0, b_i} : a_i;

endmodule

`default_nettype wire
