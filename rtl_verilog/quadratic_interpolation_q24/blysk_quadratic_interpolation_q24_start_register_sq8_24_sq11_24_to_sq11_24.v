// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device quadratic-interpolation, format q24, 24 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q24_start_register_sq8_24_sq11_24_to_sq11_24 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire signed [32:0] d_i,  // SQ8.24
    input  wire signed [35:0] sum_i,  // SQ11.24
    output reg  signed [35:0] q_o  // SQ11.24
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 36'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? {{3{d_i[32]}}, d_i} : sum_i;
    end
  end

endmodule

`default_nettype wire
