// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_pipe_uq8_0_4 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [7:0] d_i,  // UQ8.0
    output reg  [7:0] q_o  // UQ8.0
);

  reg  [7:0] held_0;
  reg  [7:0] held_1;
  reg  [7:0] held_2;

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
      q_o <= 8'd0;
    end else if (go_i) begin
      q_o <= held_2;
    end
  end

endmodule

`default_nettype wire
