// SPDX-License-Identifier: Apache-2.0
// Control: takes a line, prepares its first pixel, draws until carry_i.
// device angle, format q16, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q16_scan_control (
    input  wire clk,
    input  wire rst_n,
    input  wire start_i,
    input  wire carry_i,
    output wire load_o,
    output wire first_o,
    output wire step_o,
    output wire draw_o,
    output wire ready_o
);

  reg  [1:0] now;  // UQ2.0

  assign load_o = start_i && now == 2'd0;
  assign first_o = now == 2'd1;
  assign step_o = now == 2'd1 || now == 2'd2;
  assign draw_o = now == 2'd2;
  assign ready_o = now == 2'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      now <= 2'd0;
    end else begin
      now <= (start_i && now == 2'd0) ? 2'd1 : (now == 2'd1) ? 2'd2 : (now == 2'd2 && !carry_i) ? 2'd2 : 2'd0;
    end
  end

endmodule

`default_nettype wire
