// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_pipe_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire d_i,
    output reg  q_o
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 1'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
