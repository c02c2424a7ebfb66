// SPDX-License-Identifier: Apache-2.0
// Counter: takes d_i while load_i is one, else goes down while count_i is.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_down_counter_uq10_0 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire count_i,
    input  wire [9:0] d_i,  // UQ10.0, codes 1..1023
    output wire carry_o
);

  reg  [9:0] left;  // UQ10.0, codes 1..1023

  assign carry_o = left[9:1] == 9'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      left <= 10'd0;
    end else if (load_i || count_i) begin
      left <= load_i ? d_i : (left == 10'd0) ? left : left - 10'd1;
    end
  end

endmodule

`default_nettype wire
