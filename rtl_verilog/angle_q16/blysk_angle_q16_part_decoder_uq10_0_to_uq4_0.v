// SPDX-License-Identifier: Apache-2.0
// Decoder: part_o = n_i below FIRST, else 0.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_part_decoder_uq10_0_to_uq4_0 #(
    parameter [63:0] FIRST = 64'd0
) (
    input  wire [9:0] n_i,  // UQ10.0, codes 1..1000
    output wire [3:0] part_o  // UQ4.0
);

  assign part_o = ($signed({54'b0, n_i}) < $signed(FIRST)) ? n_i[3:0] : 4'd0;

endmodule

`default_nettype wire
