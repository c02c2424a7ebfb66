// SPDX-License-Identifier: Apache-2.0
// Takes the sign away: y_o = |a_i|.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_magnitude_sq8_26_to_uq8_26 (
    input  wire signed [34:0] a_i,  // SQ8.26
    output wire [33:0] y_o  // UQ8.26
);

  assign y_o = a_i[34] ? 34'd0 - a_i[33:0] : a_i[33:0];

endmodule

`default_nettype wire
