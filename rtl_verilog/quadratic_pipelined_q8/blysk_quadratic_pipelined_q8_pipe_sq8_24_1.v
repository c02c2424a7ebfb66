// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q8, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q8_pipe_sq8_24_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire signed [32:0] d_i,  // SQ8.24
    output reg  signed [32:0] q_o  // SQ8.24
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 33'd0;
    end else if (go_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
