// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device schlick-iterative, format q12, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q12_divide_steps_uq1_12_uq10_12_to_uq1_13 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [12:0] a_i,  // UQ1.12, codes 0..4096
    input  wire [21:0] b_i,  // UQ10.12
    output wire [13:0] q_o  // UQ1.13, codes 0..8192
);

  reg  [13:0] digits;  // UQ1.13, codes 0..8192
  reg  [21:0] divisor;  // UQ22.0
  reg  [22:0] rest;  // UQ23.0
  wire flag = load_i || step_i;
  wire [22:0] selected = load_i ? {10'b0, a_i} : rest;
  wire [21:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 23'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[21:0] : selected[21:0] - selected2) & 22'd4194303, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 22'd0;
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
