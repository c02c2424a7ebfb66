// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_pipe_uq1_7_3 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [7:0] d_i,  // UQ1.7, codes 0..128
    output reg  [7:0] q_o  // UQ1.7, codes 0..128
);

  reg  [7:0] held_0;
  reg  [7:0] held_1;

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
      q_o <= 8'd0;
    end else if (go_i) begin
      q_o <= held_1;
    end
  end

endmodule

`default_nettype wire
