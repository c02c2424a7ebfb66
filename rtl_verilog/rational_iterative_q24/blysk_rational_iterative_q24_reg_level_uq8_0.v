// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_reg_level_uq8_0 (
    input  wire clk,
    input  wire rst_n,
    input  wire [7:0] d_i,  // UQ8.0
    input  wire we_i,
    output reg  [7:0] q_o  // UQ8.0
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 8'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
