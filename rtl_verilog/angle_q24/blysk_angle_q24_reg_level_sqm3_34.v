// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device angle, format q24, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q24_reg_level_sqm3_34 (
    input  wire clk,
    input  wire rst_n,
    input  wire signed [31:0] d_i,  // SQ-3.34
    input  wire we_i,
    output reg  signed [31:0] q_o  // SQ-3.34
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 32'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
