// SPDX-License-Identifier: Apache-2.0
// Takes the sign away: y_o = |a_i|.
// device restoring-divider, format q8, 16 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q8_magnitude_sq8_0_to_uq8_0 (
    input  wire signed [8:0] a_i,  // SQ8.0, codes -255..255
    output wire [7:0] y_o  // UQ8.0
);

  assign y_o = a_i[8] ? 8'd0 - a_i[7:0] : a_i[7:0];

endmodule

`default_nettype wire
