// SPDX-License-Identifier: Apache-2.0
// Barrel shifter: y_o = a_i moved down by places_i.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_shift_right_uq1_15_uq4_0_to_uq1_15 (
    input  wire [15:0] a_i,  // UQ1.15
    input  wire [3:0] places_i,  // UQ4.0
    output wire [15:0] y_o  // UQ1.15
);

  wire [15:0] selected = (places_i[0] & 1'd1) ? {1'b0, a_i[15:1]} : a_i;
  wire [15:0] selected2 = (places_i[1] & 1'd1) ? {2'b0, selected[15:2]} : selected;
  wire [15:0] selected3 = (places_i[2] & 1'd1) ? {4'b0, selected2[15:4]} : selected2;

  assign y_o = (places_i[3] & 1'd1) ? {8'b0, selected3[15:8]} : selected3;

endmodule

`default_nettype wire
