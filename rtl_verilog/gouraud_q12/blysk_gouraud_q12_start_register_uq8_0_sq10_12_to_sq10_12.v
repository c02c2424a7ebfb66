// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device gouraud, format q12, 12 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q12_start_register_uq8_0_sq10_12_to_sq10_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [7:0] d_i,  // UQ8.0
    input  wire signed [22:0] sum_i,  // SQ10.12
    output reg  signed [22:0] q_o  // SQ10.12
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 23'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? {3'b0, d_i, 12'b0} : sum_i;
    end
  end

endmodule

`default_nettype wire
