// SPDX-License-Identifier: Apache-2.0
// What holds for the exported interpolator by forward differences after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port is
// called after the net that it reads.
`default_nettype none

module states #(
    parameter F = 8
) (
    input wire clk,
    input wire rst_n,
    input wire start_i,
    input wire ready_o,
    input wire valid_o,
    input wire [9:0] length_i,
    input wire [7:0] r_o,
    input wire [7:0] g_o,
    input wire [7:0] b_o,
    input wire [10:0] \control.left
);

  // range: of the counter
  always @* begin
    assert (\control.left <= 1024);
    assert (ready_o == !valid_o);
  end

`ifdef OVER_TIME
  // hold: the outputs keep their values while there is no line; protocol: after the edge that took a line valid_o is one for
  // length + 1 cycles, and at no other time
  reg was_reset = 0, was_idle = 0;
  reg [10:0] owed = 0;
  reg [23:0] before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && ready_o && !start_i;
    before <= {r_o, g_o, b_o};
    if (!rst_n) owed <= 0;
    else if (start_i && ready_o) owed <= length_i + 1;
    else if (valid_o) owed <= owed - 1;
  end
  always @* begin
    assert (owed == \control.left );
    assert (valid_o == (owed != 0));
    if (was_reset) assert (ready_o && {r_o, g_o, b_o} == 0);
    if (was_idle) assert ({r_o, g_o, b_o} == before);
  end
`endif

endmodule

`default_nettype wire
