// SPDX-License-Identifier: Apache-2.0
// Takes the sign away: y_o = |a_i|.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_magnitude_sq8_18_to_uq8_18 (
    input  wire signed [26:0] a_i,  // SQ8.18
    output wire [25:0] y_o  // UQ8.18
);

  assign y_o = a_i[26] ? 26'd0 - a_i[25:0] : a_i[25:0];

endmodule

`default_nettype wire
