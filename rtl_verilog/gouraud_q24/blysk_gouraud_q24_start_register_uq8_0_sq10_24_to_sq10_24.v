// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device gouraud, format q24, 24 shifts, exported from the SystemC model.
`default_nettype none

module blysk_gouraud_q24_start_register_uq8_0_sq10_24_to_sq10_24 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [7:0] d_i,  // UQ8.0
    input  wire signed [34:0] sum_i,  // SQ10.24
    output reg  signed [34:0] q_o  // SQ10.24
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 35'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? {3'b0, d_i, 24'b0} : sum_i;
    end
  end

endmodule

`default_nettype wire
