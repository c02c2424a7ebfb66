// SPDX-License-Identifier: Apache-2.0
// Control: counts the length_i + 1 pixels of a scan line.
// device quadratic-interpolation, format q24, 24 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q24_pixel_counter_uq10_0 (
    input  wire clk,
    input  wire rst_n,
    input  wire start_i,
    input  wire [9:0] length_i,  // UQ10.0
    output wire load_o,
    output wire draw_o,
    output wire ready_o
);

  reg  [10:0] left;  // UQ11.0

  assign load_o = start_i && left == 11'd0;
  assign draw_o = !(left == 11'd0);
  assign ready_o = left == 11'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      left <= 11'd0;
    end else begin
      left <= (start_i && left == 11'd0) ? {1'b0, length_i} + 11'd1 : (left == 11'd0) ? left : left - 11'd1;
    end
  end

endmodule

`default_nettype wire
