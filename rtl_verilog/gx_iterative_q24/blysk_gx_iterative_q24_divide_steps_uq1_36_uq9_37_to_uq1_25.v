// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device gx-iterative, format q24, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q24_divide_steps_uq1_36_uq9_37_to_uq1_25 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [36:0] a_i,  // UQ1.36, codes 0..68719476736
    input  wire [45:0] b_i,  // UQ9.37
    output wire [25:0] q_o  // UQ1.25, codes 0..33554432
);

  reg  [25:0] digits;  // UQ1.25, codes 0..33554432
  reg  [45:0] divisor;  // UQ46.0
  reg  [46:0] rest;  // UQ47.0
  wire flag = load_i || step_i;
  wire [46:0] selected = load_i ? {9'b0, a_i, 1'b0} : rest;
  wire [45:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 47'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[45:0] : selected[45:0] - selected2) & 46'd70368744177663, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 46'd0;
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
