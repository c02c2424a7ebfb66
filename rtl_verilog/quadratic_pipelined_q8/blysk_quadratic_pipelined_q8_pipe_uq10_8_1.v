// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_pipe_uq10_8_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [17:0] d_i,  // UQ10.8
    output reg  [17:0] q_o  // UQ10.8
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 18'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
