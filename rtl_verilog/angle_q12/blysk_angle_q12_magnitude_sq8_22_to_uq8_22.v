// SPDX-License-Identifier: Apache-2.0
// Takes the sign away: y_o = |a_i|.
// device angle, format q12, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q12_magnitude_sq8_22_to_uq8_22 (
    input  wire signed [30:0] a_i,  // SQ8.22
    output wire [29:0] y_o  // UQ8.22
);

  assign y_o = a_i[30] ? 30'd0 - a_i[29:0] : a_i[29:0];

endmodule

`default_nettype wire
