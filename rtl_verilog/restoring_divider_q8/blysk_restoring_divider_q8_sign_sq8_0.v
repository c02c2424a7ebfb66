// SPDX-License-Identifier: Apache-2.0
// The sign of a_i: negative_o = a_i < 0.
// device restoring-divider, format q8, 16 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q8_sign_sq8_0 (
    input  wire signed [8:0] a_i,  // SQ8.0, codes -255..255
    output wire negative_o
);

  wire [7:0] unused_a_i_low = a_i[7:0];  // below the last place of the result

  assign negative_o = a_i[8];

endmodule

`default_nettype wire
