// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device lighting, format q12, no energy factor, exported from the SystemC model.
`default_nettype none

module blysk_lighting_q12_reg_level_uq8_16 (
    input  wire clk,
    input  wire rst_n,
    input  wire [23:0] d_i,  // UQ8.16, codes 0..16711680
    input  wire we_i,
    output reg  [23:0] q_o  // UQ8.16, codes 0..16711680
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 24'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
