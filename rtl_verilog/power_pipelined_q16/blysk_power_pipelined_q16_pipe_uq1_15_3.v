// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_pipe_uq1_15_3 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [15:0] d_i,  // UQ1.15, codes 0..32768
    output reg  [15:0] q_o  // UQ1.15, codes 0..32768
);

  reg  [15:0] held_0;
  reg  [15:0] held_1;

  always @(posedge clk) begin
    if (!rst_n) begin
      held_0 <= 16'd0;
    end else if (go_i) begin
      held_0 <= d_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      held_1 <= 16'd0;
    end else if (go_i) begin
      held_1 <= held_0;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 16'd0;
    end else if (go_i) begin
      q_o <= held_1;
    end
  end

endmodule

`default_nettype wire
