// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device quadratic-interpolation, format q12, 12 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q12_start_register_sq0_12_sq0_12_to_sq0_12 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire signed [12:0] d_i,  // SQ0.12
    input  wire signed [12:0] sum_i,  // SQ0.12
    output reg  signed [12:0] q_o  // SQ0.12
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 13'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? d_i : sum_i;
    end
  end

endmodule

`default_nettype wire
