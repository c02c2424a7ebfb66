// SPDX-License-Identifier: Apache-2.0
// Takes the sign away: y_o = |a_i|.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_magnitude_sq8_34_to_uq8_34 (
    input  wire signed [42:0] a_i,  // SQ8.34
    output wire [41:0] y_o  // UQ8.34
);

  assign y_o = a_i[42] ? 42'd0 - a_i[41:0] : a_i[41:0];

endmodule

`default_nettype wire
