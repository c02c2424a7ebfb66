// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_reg_level_uq10_0 (
    input  wire clk,
    input  wire rst_n,
    input  wire [9:0] d_i,  // UQ10.0, codes 1..1000
    input  wire we_i,
    output reg  [9:0] q_o  // UQ10.0, codes 1..1000
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
