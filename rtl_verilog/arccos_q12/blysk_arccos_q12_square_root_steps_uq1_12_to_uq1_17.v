// SPDX-License-Identifier: Apache-2.0
// Square root: takes d_i while load_i is one, else finds a digit.
// device arccos, format q12, 18 digits of the root, table of 65 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q12_square_root_steps_uq1_12_to_uq1_17 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [12:0] d_i,  // UQ1.12, codes 0..4096
    output wire [17:0] root_o  // UQ1.17
);

  reg  [17:0] digits;  // UQ1.17
  reg  [18:0] remainder;  // UQ19.0
  reg  [13:0] rest;  // UQ2.12
  wire flag = load_i || step_i;
  wire [20:0] sum = {remainder, 2'b0} + {19'b0, rest[13:12]};
  wire [19:0] sum2 = {digits, 2'b0} + 20'd1;

  assign root_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 14'd0;
    end else if (flag) begin
      rest <= load_i ? {1'b0, d_i} : {rest[11:0] & 12'd4095, 2'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      remainder <= 19'd0;
    end else if (flag) begin
      remainder <= load_i ? 19'd0 : (sum < {1'b0, sum2}) ? sum[18:0] : sum[18:0] - sum2[18:0];
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 18'd0;
    end else if (flag) begin
      digits <= load_i ? 18'd0 : ({remainder, 2'b0} + {19'b0, rest[13:12]} < {1'b0, {digits, 2'b0} + 20'd1}) ? {digits[16:0], 1'b0} : {digits[16:0], 1'b0} + 18'd1;
    end
  end

endmodule

`default_nettype wire
