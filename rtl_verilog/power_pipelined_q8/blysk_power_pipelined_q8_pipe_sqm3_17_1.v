// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q8, 4 lines for the logarithm, 8 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q8_pipe_sqm3_17_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire signed [14:0] d_i,  // SQ-3.17
    output reg  signed [14:0] q_o  // SQ-3.17
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 15'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
