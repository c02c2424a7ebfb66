// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i by the trailing edge of we_i, as clk samples it.
// device rational, format q16, coefficients from two memories of 1000 words, exported from the SystemC model.
`default_nettype none

module blysk_rational_q16_reg_trailing_uq1_16 (
    input  wire clk,
    input  wire rst_n,
    input  wire [16:0] d_i,  // UQ1.16, codes 0..65536
    input  wire we_i,
    output reg  [16:0] q_o  // UQ1.16, codes 0..65536
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
      q_o <= 17'd0;
    end else if (we_q && !we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
