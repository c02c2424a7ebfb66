// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_pipe_uq8_0_7 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [7:0] d_i,  // UQ8.0
    output reg  [7:0] q_o  // UQ8.0
);

  reg  [7:0] held_0;
  reg  [7:0] held_1;
  reg  [7:0] held_2;
  reg  [7:0] held_3;
  reg  [7:0] held_4;
  reg  [7:0] held_5;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 8'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_1 <= 8'd0;
    end else if (go_i) begin
      held_1 <= held_0;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_2 <= 8'd0;
    end else if (go_i) begin
      held_2 <= held_1;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_3 <= 8'd0;
    end else if (go_i) begin
      held_3 <= held_2;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_4 <= 8'd0;
    end else if (go_i) begin
      held_4 <= held_3;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_5 <= 8'd0;
    end else if (go_i) begin
      held_5 <= held_4;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 8'd0;
    end else if (go_i) begin
      q_o <= held_5;
    end
  end

endmodule

`default_nettype wire
