// SPDX-License-Identifier: Apache-2.0
// Register of an interpolator: d_i while load_i is one, else sum_i.
// device quadratic-interpolation, format q16, 16 fraction bits, exported from the SystemC model.
`default_nettype none

module blysk_quadratic_interpolation_q16_start_register_sq0_16_sq0_16_to_sq0_16 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire signed [16:0] d_i,  // SQ0.16
    input  wire signed [16:0] sum_i,  // SQ0.16
    output reg  signed [16:0] q_o  // SQ0.16
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 17'd0;
    end else if (load_i || step_i) begin
      q_o <= load_i ? d_i : sum_i;
    end
  end

endmodule

`default_nettype wire
