// SPDX-License-Identifier: Apache-2.0
// Register: takes d_i while we_i is one.
// device angle, format q8, Q 0.5, k 5, exported from the SystemC model.
`default_nettype none

module blysk_angle_q8_reg_level_sq8_18 (
    input  wire clk,
    input  wire rst_n,
    input  wire signed [26:0] d_i,  // SQ8.18
    input  wire we_i,
    output reg  signed [26:0] q_o  // SQ8.18
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 27'd0;
    end else if (we_i) begin
      q_o <= d_i;
    end
  end

endmodule

`default_nettype wire
