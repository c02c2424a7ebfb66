// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device gx-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_gx_iterative_q8_divide_steps_uq1_16_uq9_17_to_uq1_9 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [16:0] a_i,  // UQ1.16, codes 0..65536
    input  wire [25:0] b_i,  // UQ9.17
    output wire [9:0] q_o  // UQ1.9, codes 0..512
);

  reg  [9:0] digits;  // UQ1.9, codes 0..512
  reg  [25:0] divisor;  // UQ26.0
  reg  [26:0] rest;  // UQ27.0
  wire flag = load_i || step_i;
  wire [26:0] selected = load_i ? {9'b0, a_i, 1'b0} : rest;
  wire [25:0] selected2 = load_i ? b_i : divisor;
  wire flag2 = selected < {1'b0, selected2};

  assign q_o = digits;
  always @(posedge clk) begin
    if (!rst_n) begin
      rest <= 27'd0;
    end else if (flag) begin
      rest <= {(flag2 ? selected[25:0] : selected[25:0] - selected2) & 26'd67108863, 1'b0};
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      divisor <= 26'd0;
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
