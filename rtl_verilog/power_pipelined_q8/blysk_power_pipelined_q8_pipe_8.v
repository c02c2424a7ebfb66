// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_pipe_8 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire d_i,
    output reg  q_o
);

  reg  held_0;
  reg  held_1;
  reg  held_2;
  reg  held_3;
  reg  held_4;
  reg  held_5;
  reg  held_6;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 1'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_1 <= 1'd0;
    end else if (go_i) begin
      held_1 <= held_0;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_2 <= 1'd0;
    end else if (go_i) begin
      held_2 <= held_1;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_3 <= 1'd0;
    end else if (go_i) begin
      held_3 <= held_2;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_4 <= 1'd0;
    end else if (go_i) begin
      held_4 <= held_3;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_5 <= 1'd0;
    end else if (go_i) begin
      held_5 <= held_4;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_6 <= 1'd0;
    end else if (go_i) begin
      held_6 <= held_5;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 1'd0;
    end else if (go_i) begin
      q_o <= held_6;
    end
  end

endmodule

`default_nettype wire
