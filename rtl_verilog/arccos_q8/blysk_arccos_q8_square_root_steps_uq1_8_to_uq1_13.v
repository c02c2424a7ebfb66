// SPDX-License-Identifier: Apache-2.0
// Square root: takes d_i while load_i is one, else finds a digit.
// device arccos, format q8, 14 digits of the root, table of 17 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q8_square_root_steps_uq1_8_to_uq1_13 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [8:0] d_i,  // UQ1.8, codes 0..256
    output wire [13:0] root_o  // UQ1.13
);

  reg  [13:0] digits;  // UQ1.13
  reg  [14:0] remainder;  // UQ15.0
  reg  [9:0] rest;  // UQ2.8
  wire flag = load_i || step_i;
  wire [16:0] sum = {remainder, 2'b0} + {15'b0, rest[9:8]};
  wire [15:0] sum2 = {digits, 2'b0} + 16'd1;

  assign root_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 10'd0;
    end else if (flag) begin
      rest <= load_i ? {1'b0, d_i} : {rest[7:0] & 8'd255, 2'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      remainder <= 15'd0;
    end else if (flag) begin
      remainder <= load_i ? 15'd0 : (sum < {1'b0, sum2}) ? sum[14:0] : sum[14:0] - sum2[14:0];
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 14'd0;
    end else if (flag) begin
      digits <= load_i ? 14'd0 : ({remainder, 2'b0} + {15'b0, rest[9:8]} < {1'b0, {digits, 2'b0} + 16'd1}) ? {digits[12:0], 1'b0} : {digits[12:0], 1'b0} + 14'd1;
    end
  end

endmodule

`default_nettype wire
