// SPDX-License-Identifier: Apache-2.0
// Registers of a pipeline: d_i moves on by one while go_i is one.
// device quadratic-pipelined, format q16, coefficient derived, BRDF clamped to [0, 1], 5 stages, cuts 1,2,3,5, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_pipelined_q16_pipe_uq1_16_1 (
    input  wire clk,
    input  wire rst_n,
    input  wire go_i,
    input  wire [16:0] d_i,  // UQ1.16, codes 0..65536
    output reg  [16:0] q_o  // UQ1.16, codes 0..65536
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
