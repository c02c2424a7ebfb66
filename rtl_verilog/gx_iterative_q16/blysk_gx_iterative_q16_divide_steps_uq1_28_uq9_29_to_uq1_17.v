// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device gx-iterative, format q16, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q16_divide_steps_uq1_28_uq9_29_to_uq1_17 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [28:0] a_i,  // UQ1.28, codes 0..268435456
    input  wire [37:0] b_i,  // UQ9.29
    output wire [17:0] q_o  // UQ1.17, codes 0..131072
);

  reg  [17:0] digits;  // UQ1.17, codes 0..131072
  reg  [37:0] divisor;  // UQ38.0
  reg  [38:0] rest;  // UQ39.0
  wire flag = load_i || step_i;
  wire [38:0] selected = load_i ? {9'b0, a_i, 1'b0} : rest;
  wire [37:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 39'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[37:0] : selected[37:0] - selected2) & 38'd274877906943, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 38'd0;
    end else if (flag) begin
      divisor <= selected2;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      digits <= 18'd0;
    end else if (flag) begin
      digits <= (load_i ? 18'd0 : {digits[16:0], 1'b0} & 18'd262143) | {17'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
