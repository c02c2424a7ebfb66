// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device gx-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q12_divide_steps_uq1_24_uq9_25_to_uq1_13 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [33:0] b_i,  // UQ9.25
    output wire [13:0] q_o  // UQ1.13, codes 0..8192
);

  reg  [13:0] digits;  // UQ1.13, codes 0..8192
  reg  [33:0] divisor;  // UQ34.0
  reg  [34:0] rest;  // UQ35.0
  wire flag = load_i || step_i;
  wire [34:0] selected = load_i ? {9'b0, a_i, 1'b0} : rest;
  wire [33:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 35'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[33:0] : selected[33:0] - selected2) & 34'd17179869183, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 34'd0;
    end else if (flag) begin
      divisor <= selected2;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 14'd0;
    end else if (flag) begin
      digits <= (load_i ? 14'd0 : {digits[12:0], 1'b0} & 14'd16383) | {13'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
