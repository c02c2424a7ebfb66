// SPDX-License-Identifier: Apache-2.0
// Control: counts the STEPS of an operation.
// device restoring-divider, format q24, 32 digits, exported from the SystemC model.
`default_nettype none

module blysk_restoring_divider_q24_sequencer #(
    parameter [6:0] STEPS = 7'd0
) (
    input  wire clk,
    input  wire rst_n,
    input  wire start_i,
    output wire load_o,
    output wire step_o,
    output wire ready_o,
    output reg  done_o
);

  reg  [6:0] left;  // UQ7.0

  assign load_o = start_i && left == 7'd0;
  assign step_o = !(left == 7'd0);
  assign ready_o = left == 7'd0;
  always @(posedge clk) begin
    if (!rst_n) begin
      left <= 7'd0;
    end else begin
      left <= (start_i && left == 7'd0) ? STEPS : (left == 7'd0) ? left : left - 7'd1;
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
