// SPDX-License-Identifier: Apache-2.0
// Restoring divider: takes a_i and b_i while load_i is one; finds a digit of a_i / b_i.
// device rational-iterative, format q16, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q16_divide_steps_uq1_19_uq3_19_to_uq1_17 (
    input  wire clk,
    input  wire rst_n,
    input  wire load_i,
    input  wire step_i,
    input  wire [19:0] a_i,  // UQ1.19, codes 0..524288
    input  wire [21:0] b_i,  // UQ3.19
    output wire [17:0] q_o  // UQ1.17, codes 0..131072
);

  reg  [17:0] digits;  // UQ1.17, codes 0..131072
  reg  [21:0] divisor;  // UQ22.0
  reg  [22:0] rest;  // UQ23.0
  wire flag = load_i || step_i;
  wire [22:0] selected = load_i ? {3'b0, a_i} : rest;
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
      digits <= 18'd0;
    end else if (flag) begin
      digits <= (load_i ? 18'd0 : {digits[16:0], 1'b0} & 18'd262143) | {17'b0, flag2 == 1'd0};
    end
  end

endmodule

`default_nettype wire
