// SPDX-License-Identifier: Apache-2.0
// Control: takes the inputs, then counts the digits of a result.
// device rational-iterative, format q12, coefficients from two memories of 1000 words, a digit of the quotient each clock cycle, exported from the SystemC model.
`default_nettype none

module blysk_rational_iterative_q12_digit_control_14 (
    input  wire clk,
    input  wire rst_n,
    input  wire start_i,
    output wire take_o,
    output wire first_o,
    output wire step_o,
    output wire ready_o,
    output reg  done_o
);

  reg  [6:0] left;  // UQ7.0

  assign take_o = start_i && left == 7'd0;
  assign first_o = left == 7'd14;
  assign step_o = !(left == 7'd0);
  assign ready_o = left == 7'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      left <= 7'd0;
    end else begin
      left <= (start_i && left == 7'd0) ? 7'd14 : (left == 7'd0) ? left : left - 7'd1;
    end
  end
  always @(posedge clk) begin
    if (!rst_n) begin
      done_o <= 1'd0;
    end else begin
      done_o <= left == 7'd1;
    end
  end

endmodule

`default_nettype wire
