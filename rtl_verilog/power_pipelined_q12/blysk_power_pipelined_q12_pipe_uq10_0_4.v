// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_pipe_uq10_0_4 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [9:0] d_i,  // UQ10.0, codes 1..1000
    output reg  [9:0] q_o  // UQ10.0, codes 1..1000
);

  reg  [9:0] held_0;
  reg  [9:0] held_1;
  reg  [9:0] held_2;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 10'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_1 <= 10'd0;
    end else if (go_i) begin
      held_1 <= held_0;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_2 <= 10'd0;
    end else if (go_i) begin
      held_2 <= held_1;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 10'd0;
    end else if (go_i) begin
      q_o <= held_2;
    end
  end

endmodule

`default_nettype wire
