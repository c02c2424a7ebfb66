// SPDX-License-Identifier: Apache-2.0
// Control: counts the STEPS that prepare a scan line, then its length_i + 1 pixels.
// device gouraud, format q12, 12 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q12_line_control_uq10_0 #(
    parameter [6:0] STEPS = 7'd0
) (
    input  wire clk,
    input  wire rst_n,
    input  wire start_i,
    input  wire [9:0] length_i,  // UQ10.0, codes 1..1023
    output wire load_o,
    output wire step_o,
    output wire draw_o,
    output wire ready_o
);

  reg  [10:0] pixels_left;  // UQ11.0
  reg  [6:0] steps_left;  // UQ7.0

  assign load_o = start_i && pixels_left == 11'd0;
  assign step_o = !(steps_left == 7'd0);
  assign draw_o = steps_left == 7'd0 && !(pixels_left == 11'd0);
  assign ready_o = pixels_left == 11'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      steps_left <= 7'd0;
    end else begin
      steps_left <= (start_i && pixels_left == 11'd0) ? STEPS : (steps_left == 7'd0) ? steps_left : steps_left - 7'd1;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      pixels_left <= 11'd0;
    end else begin
      pixels_left <= (start_i && pixels_left == 11'd0) ? {1'b0, length_i} + 11'd1 : (!(steps_left == 7'd0)) ? pixels_left : (pixels_left == 11'd0) ? pixels_left : pixels_left - 11'd1;
    end
  end

endmodule

`default_nettype wire
