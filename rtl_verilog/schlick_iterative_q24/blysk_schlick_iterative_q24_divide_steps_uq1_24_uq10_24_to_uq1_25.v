// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device schlick-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q24_divide_steps_uq1_24_uq10_24_to_uq1_25 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [24:0] a_i,  // UQ1.24, codes 0..16777216
    input  wire [33:0] b_i,  // UQ10.24
    output wire [25:0] q_o  // UQ1.25, codes 0..33554432
);

  reg  [25:0] digits;  // UQ1.25, codes 0..33554432
  reg  [33:0] divisor;  // UQ34.0
  reg  [34:0] rest;  // UQ35.0
  wire flag = load_i || step_i;
  wire [34:0] selected = load_i ? {10'b0, a_i} : rest;
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
      digits <= 26'd0;
    end else if (flag) begin
      digits <= (load_i ? 26'd0 : {digits[24:0], 1'b0} & 26'd67108863) | {25'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
