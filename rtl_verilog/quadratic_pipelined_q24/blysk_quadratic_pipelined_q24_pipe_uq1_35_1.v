// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q24, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q24_pipe_uq1_35_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [35:0] d_i,  // UQ1.35
    output reg  [35:0] q_o  // UQ1.35
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 36'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
