// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_divide_steps_uq1_15_uq3_15_to_uq1_13 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [15:0] a_i,  // UQ1.15, codes 0..32768
    input  wire [17:0] b_i,  // UQ3.15
    output wire [13:0] q_o  // UQ1.13, codes 0..8192
);

  reg  [13:0] digits;  // UQ1.13, codes 0..8192
  reg  [17:0] divisor;  // UQ18.0
  reg  [18:0] rest;  // UQ19.0
  wire flag = load_i || step_i;
  wire [18:0] selected = load_i ? {3'b0, a_i} : rest;
  wire [17:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 19'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[17:0] : selected[17:0] - selected2) & 18'd262143, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 18'd0;
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
