// SPDX-License-Identifier: Apache-2.0
// What holds for the exported shift divider after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port
// is called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire ready_o,
    input wire valid_o,
    input wire signed [F+8:0] increment_o,
    input wire [6:0] \control.left ,
    input wire [F:0] \rg_digits.held ,
    input wire signed [F+7:0] \rg_shift.held
);

  wire [6:0] left = \control.left ;
  wire [F:0] digits = \rg_digits.held ;
  wire signed [F+7:0] shifted = \rg_shift.held ;
  wire busy = left != 0;
  wire signed [F+10:0] unit = $signed({{F + 10{1'b0}}, 1'b1}) <<< left;
  wire signed [F+10:0] one = $signed({{F + 10{1'b0}}, 1'b1}) <<< F;

  // range: of each register; a difference is -256..255, one code more than is legal
  always @* begin
    assert (left <= F);
    assert (ready_o == !busy);
    assert (!(valid_o && busy));
    // The digits that are still to come are the uppermost ones, `left` of them.
    assert ((digits & ~({F + 1{1'b1}} << (F + 1 - left))) == 0);
    if (busy) assert (2 * shifted >= -256 * unit && 2 * shifted <= 255 * unit);
    else assert (shifted >= -128 && shifted <= 127);
    // Only the sum of i_0 alone is that large, and it is 1 for no length with another digit.
    if (digits == 0) assert (increment_o >= -256 * one && increment_o <= 255 * one);
    else assert (increment_o >= -256 * (one - unit) && increment_o <= 255 * (one - unit));
  end

`ifdef OVER_TIME
  // hold: increment_o keeps its value while there is no job; protocol: F + 1 edges after the one that took a row valid_o is
  // one, for one cycle, and at no other time
  reg was_reset = 0, was_idle = 0, is_due = 0;
  reg [6:0] waited = 0;
  reg signed [F+8:0] before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && ready_o && !start_i;
    before <= increment_o;
    is_due <= rst_n && waited == F;
    if (!rst_n || waited == F) waited <= rst_n && start_i && ready_o;
    else if (waited != 0) waited <= waited + 1;
    else waited <= start_i && ready_o;
  end
  always @* begin
    assert (waited == (busy ? F + 1 - left : 0));
    assert (valid_o == is_due);
    if (was_reset) assert (ready_o && !valid_o && increment_o == 0);
    if (was_idle) assert (increment_o == before);
  end
`endif

endmodule

`default_nettype wire
