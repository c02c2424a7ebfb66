// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device restoring-divider, format q12, 20 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q12_divide_steps_uq0_8_uq10_0_to_uq1_20 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [7:0] a_i,  // UQ0.8
    input  wire [9:0] b_i,  // UQ10.0, codes 1..1023
    output wire [20:0] q_o  // UQ1.20
);

  reg  [20:0] digits;  // UQ1.20
  reg  [17:0] divisor;  // UQ18.0
  reg  [18:0] rest;  // UQ19.0
  wire flag = load_i || step_i;
  wire [18:0] selected = load_i ? {11'b0, a_i} : rest;
  wire [17:0] selected2 = load_i ? {b_i, 8'b0} : divisor;
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
      digits <= 21'd0;
    end else if (flag) begin
      digits <= (load_i ? 21'd0 : {digits[19:0], 1'b0} & 21'd2097151) | {20'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
