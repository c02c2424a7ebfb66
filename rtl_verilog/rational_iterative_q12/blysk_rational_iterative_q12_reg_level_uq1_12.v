// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_reg_level_uq1_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire [12:0] d_i,  // UQ1.12, codes 0..4096
    input  wire we_i,
    output reg  [12:0] q_o  // UQ1.12, codes 0..4096
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 13'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
