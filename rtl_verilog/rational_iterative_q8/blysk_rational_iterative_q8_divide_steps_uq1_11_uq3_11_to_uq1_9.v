// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device rational-iterative, format q8, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q8_divide_steps_uq1_11_uq3_11_to_uq1_9 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [11:0] a_i,  // UQ1.11, codes 0..2048
    input  wire [13:0] b_i,  // UQ3.11
    output wire [9:0] q_o  // UQ1.9, codes 0..512
);

  reg  [9:0] digits;  // UQ1.9, codes 0..512
  reg  [13:0] divisor;  // UQ14.0
  reg  [14:0] rest;  // UQ15.0
  wire flag = load_i || step_i;
  wire [14:0] selected = load_i ? {3'b0, a_i} : rest;
  wire [13:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 15'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[13:0] : selected[13:0] - selected2) & 14'd16383, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 14'd0;
    end else if (flag) begin
      divisor <= selected2;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 10'd0;
    end else if (flag) begin
      digits <= (load_i ? 10'd0 : {digits[8:0], 1'b0} & 10'd1023) | {9'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
