// SPDX-License-Identifier: Apache-2.0
// Square root: takes d_i while load_i is one, else finds a digit.
// device arccos, format q24, 30 digits of the root, table of 4097 words, exported from the SystemC model.
`default_nettype none

module blysk_arccos_q24_square_root_steps_uq1_24_to_uq1_29 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [24:0] d_i,  // UQ1.24, codes 0..16777216
    output wire [29:0] root_o  // UQ1.29
);

  reg  [29:0] digits;  // UQ1.29
  reg  [30:0] remainder;  // UQ31.0
  reg  [25:0] rest;  // UQ2.24
  wire flag = load_i || step_i;
  wire [32:0] sum = {remainder, 2'b0} + {31'b0, rest[25:24]};
  wire [31:0] sum2 = {digits, 2'b0} + 32'd1;

  assign root_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 26'd0;
    end else if (flag) begin
      rest <= load_i ? {1'b0, d_i} : {rest[23:0] & 24'd16777215, 2'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      remainder <= 31'd0;
    end else if (flag) begin
      remainder <= load_i ? 31'd0 : (sum < {1'b0, sum2}) ? sum[30:0] : sum[30:0] - sum2[30:0];
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 30'd0;
    end else if (flag) begin
      digits <= load_i ? 30'd0 : ({remainder, 2'b0} + {31'b0, rest[25:24]} < {1'b0, {digits, 2'b0} + 32'd1}) ? {digits[28:0], 1'b0} : {digits[28:0], 1'b0} + 30'd1;
    end
  end

endmodule

`default_nettype wire
