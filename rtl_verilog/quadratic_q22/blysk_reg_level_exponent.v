// SPDX-License-Identifier: Apache-2.0
// reg_level<exponent>, exported from the SystemC model.
`default_nettype none

module blysk_reg_level_exponent (
    input  wire clk,
    input  wire rst_n,
    input  wire [9:0] d_i,
    input  wire we_i,
    output reg  [9:0] q_o
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 10'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
