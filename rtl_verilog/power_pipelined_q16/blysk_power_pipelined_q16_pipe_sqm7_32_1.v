// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q16, 64 lines for the logarithm, 128 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q16_pipe_sqm7_32_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire signed [25:0] d_i,  // SQ-7.32
    output reg  signed [25:0] q_o  // SQ-7.32
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 26'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
