// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q12, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q12_pipe_uq1_24_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [24:0] d_i,  // UQ1.24
    output reg  [24:0] q_o  // UQ1.24
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 25'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
