// SPDX-License-Identifier: Apache-2.0
// Barrel shifter: y_o = a_i moved down by places_i.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_shift_right_uq1_19_uq5_0_to_uq1_19 (
    input  wire [19:0] a_i,  // UQ1.19
    input  wire [4:0] places_i,  // UQ5.0
    output wire [19:0] y_o  // UQ1.19
);

  wire [19:0] selected = (places_i[0] & 1'd1) ? {1'b0, a_i[19:1]} : a_i;
  wire [19:0] selected2 = (places_i[1] & 1'd1) ? {2'b0, selected[19:2]} : selected;
  wire [19:0] selected3 = (places_i[2] & 1'd1) ? {4'b0, selected2[19:4]} : selected2;
  wire [19:0] selected4 = (places_i[3] & 1'd1) ? {8'b0, selected3[19:8]} : selected3;

  assign y_o = (places_i[4] & 1'd1) ? {16'b0, selected4[19:16]} : selected4;

endmodule

`default_nettype wire
