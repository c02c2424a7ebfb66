// SPDX-License-Identifier: Apache-2.0
// Multiplexer: y_o = b_i while select_b_i is one, else a_i.
// device angle, format q12, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q12_multiplexer_sq8_22_uq1_22_to_sq8_22 (
    input  wire signed [30:0] a_i,  // SQ8.22
    input  wire [22:0] b_i,  // UQ1.22, codes 0..6588397
    input  wire select_b_i,
    output wire signed [30:0] y_o  // SQ8.22
);

  assign y_o = select_b_i ? {8'b0, b_i} : a_i;

endmodule

`default_nettype wire
