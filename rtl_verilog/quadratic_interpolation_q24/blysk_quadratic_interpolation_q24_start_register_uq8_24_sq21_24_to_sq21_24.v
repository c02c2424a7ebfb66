// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device quadratic-interpolation, format q24, 24 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q24_start_register_uq8_24_sq21_24_to_sq21_24 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [31:0] d_i,  // UQ8.24
    input  wire signed [45:0] sum_i,  // SQ21.24
    output reg  signed [45:0] q_o  // SQ21.24
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 46'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? {14'b0, d_i} : sum_i;
    end
  end

endmodule

`default_nettype wire
