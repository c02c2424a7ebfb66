// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device schlick-iterative, format q8, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_schlick_iterative_q8_divide_steps_uq1_8_uq10_8_to_uq1_9 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [8:0] a_i,  // UQ1.8, codes 0..256
    input  wire [17:0] b_i,  // UQ10.8
    output wire [9:0] q_o  // UQ1.9, codes 0..512
);

  reg  [9:0] digits;  // UQ1.9, codes 0..512
  reg  [17:0] divisor;  // UQ18.0
  reg  [18:0] rest;  // UQ19.0
  wire flag = load_i || step_i;
  wire [18:0] selected = load_i ? {10'b0, a_i} : rest;
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
      digits <= 10'd0;
    end else if (flag) begin
      digits <= (load_i ? 10'd0 : {digits[8:0], 1'b0} & 10'd1023) | {9'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
