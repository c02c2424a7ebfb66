// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i by the trailing edge of we_i, as clk samples it.
// device rational, format q24, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q24_reg_trailing_uq1_24 (
    input  wire clk,
    input  wire rst_n,
    input  wire [24:0] d_i,  // UQ1.24, codes 0..16777216
    input  wire we_i,
    output reg  [24:0] q_o  // UQ1.24, codes 0..16777216
);

  reg  we_q;

  always @(posedge clk) begin
    if (!rst_n) begin
      we_q <= 1'd0;
    end else begin
      we_q <= we_i;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 25'd0;
    end else if (we_q && !we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
