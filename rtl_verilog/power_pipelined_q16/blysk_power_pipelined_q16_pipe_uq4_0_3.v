// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_pipe_uq4_0_3 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [3:0] d_i,  // UQ4.0
    output reg  [3:0] q_o  // UQ4.0
);

  reg  [3:0] held_0;
  reg  [3:0] held_1;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 4'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_1 <= 4'd0;
    end else if (go_i) begin
      held_1 <= held_0;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 4'd0;
    end else if (go_i) begin
      q_o <= held_1;
    end
  end

endmodule

`default_nettype wire
