// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_pipe_sqm5_23_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire signed [18:0] d_i,  // SQ-5.23
    output reg  signed [18:0] q_o  // SQ-5.23
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 19'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
