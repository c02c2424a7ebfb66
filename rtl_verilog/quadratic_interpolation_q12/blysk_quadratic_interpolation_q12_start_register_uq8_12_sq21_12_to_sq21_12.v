// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device quadratic-interpolation, format q12, 12 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q12_start_register_uq8_12_sq21_12_to_sq21_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [19:0] d_i,  // UQ8.12
    input  wire signed [33:0] sum_i,  // SQ21.12
    output reg  signed [33:0] q_o  // SQ21.12
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 34'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? {14'b0, d_i} : sum_i;
    end
  end

endmodule

`default_nettype wire
