// SPDX-License-Identifier: Apache-2.0
// Square root: takes d_i while load_i is one, else finds a digit.
// device arccos, format q16, 22 digits of the root, table of 257 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q16_square_root_steps_uq1_16_to_uq1_21 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [16:0] d_i,  // UQ1.16, codes 0..65536
    output wire [21:0] root_o  // UQ1.21
);

  reg  [21:0] digits;  // UQ1.21
  reg  [22:0] remainder;  // UQ23.0
  reg  [17:0] rest;  // UQ2.16
  wire flag = load_i || step_i;
  wire [24:0] sum = {remainder, 2'b0} + {23'b0, rest[17:16]};
  wire [23:0] sum2 = {digits, 2'b0} + 24'd1;

  assign root_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 18'd0;
    end else if (flag) begin
      rest <= load_i ? {1'b0, d_i} : {rest[15:0] & 16'd65535, 2'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      remainder <= 23'd0;
    end else if (flag) begin
      remainder <= load_i ? 23'd0 : (sum < {1'b0, sum2}) ? sum[22:0] : sum[22:0] - sum2[22:0];
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 22'd0;
    end else if (flag) begin
      digits <= load_i ? 22'd0 : ({remainder, 2'b0} + {23'b0, rest[17:16]} < {1'b0, {digits, 2'b0} + 24'd1}) ? {digits[20:0], 1'b0} : {digits[20:0], 1'b0} + 22'd1;
    end
  end

endmodule

`default_nettype wire
