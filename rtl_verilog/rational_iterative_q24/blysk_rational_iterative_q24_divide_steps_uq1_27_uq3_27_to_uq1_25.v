// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device rational-iterative, format q24, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q24_divide_steps_uq1_27_uq3_27_to_uq1_25 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [27:0] a_i,  // UQ1.27, codes 0..134217728
    input  wire [29:0] b_i,  // UQ3.27
    output wire [25:0] q_o  // UQ1.25, codes 0..33554432
);

  reg  [25:0] digits;  // UQ1.25, codes 0..33554432
  reg  [29:0] divisor;  // UQ30.0
  reg  [30:0] rest;  // UQ31.0
  wire flag = load_i || step_i;
  wire [30:0] selected = load_i ? {3'b0, a_i} : rest;
  wire [29:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 31'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[29:0] : selected[29:0] - selected2) & 30'd1073741823, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 30'd0;
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
