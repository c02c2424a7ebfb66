// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q24, 1024 lines for the logarithm, 2048 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q24_pipe_uq1_28_2 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [28:0] d_i,  // UQ1.28
    output reg  [28:0] q_o  // UQ1.28
);

  reg  [28:0] held_0;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 29'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 29'd0;
    end else if (go_i) begin
      q_o <= held_0;
    end
  end

endmodule

`default_nettype wire
