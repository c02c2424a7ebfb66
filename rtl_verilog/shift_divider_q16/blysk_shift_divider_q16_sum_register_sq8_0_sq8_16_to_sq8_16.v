// SPDX-License-Identifier: Apache-2.0
// Register of an accumulating adder: d_i or 0 while load_i is one, else sum_i.
// device shift-divider, format q16, 16 shifts, exported from the SystemC model.
`default_nettype none

module blysk_shift_divider_q16_sum_register_sq8_0_sq8_16_to_sq8_16 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire add_i,
    input  wire signed [8:0] d_i,  // SQ8.0, codes -255..255
    input  wire signed [24:0] sum_i,  // SQ8.16
    output reg  signed [24:0] q_o  // SQ8.16
);

  always @(posedge clk) begin
    if (!rst_n) begin
      q_o <= 25'd0;
    end else if (load_i || step_i && add_i) begin
      q_o <= load_i ? (add_i ? {d_i, 16'b0} : 25'd0) : sum_i;
    end
  end

endmodule

`default_nettype wire
