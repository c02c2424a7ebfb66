// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device power-pipelined, format q12, 16 lines for the logarithm, 32 for the power of two, 8 stages, cuts 2,3,4,6,7,9,12, exported from the SystemC model.
`default_nettype none

module blysk_power_pipelined_q12_pipe_uq1_16_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [16:0] d_i,  // UQ1.16
    output reg  [16:0] q_o  // UQ1.16
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 17'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
