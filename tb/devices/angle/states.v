// SPDX-License-Identifier: Apache-2.0
// What holds for the exported device of UA 71489 after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port is
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
    input wire [9:0] count_i,
    input wire [F+18:0] \rg4.q_o ,
    input wire [9:0] \rg5.q_o ,
    input wire [7:0] \rg1.q_o ,
    input wire [1:0] \control.now ,
    input wire [9:0] \cnt.left
);

  wire [1:0] now = \control.now ;  // 0: idle, 1: first, 2: draw

  // range: three states
  always @* begin
    assert (now <= 2);
    assert (ready_o == (now == 0));
    assert (valid_o == (now == 2));
  end

`ifdef OVER_TIME
  // hold: registers 1, 4 and 5, which alone make the output, keep their values while there is no line; protocol: two edges
  // after the one that took a line valid_o becomes one, for count cycles, of 0 for one, and it is one at no other time
  reg was_reset = 0, was_idle = 0, was_taken = 0;
  reg [9:0] owed = 0;
  reg [F+36:0] before = 0;
  wire [F+36:0] held = {\rg1.q_o , \rg4.q_o , \rg5.q_o };
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_idle <= rst_n && ready_o && !start_i;
    was_taken <= rst_n && start_i && ready_o;
    before <= held;
    if (!rst_n) owed <= 0;
    else if (start_i && ready_o) owed <= count_i == 0 ? 1 : count_i;
    else if (valid_o) owed <= owed - 1;
  end
  always @* begin
    assert (was_taken == (now == 1));
    assert (ready_o == (owed == 0));
    assert (valid_o == (owed != 0 && !was_taken));
    assert (now == 0 || owed == (\cnt.left == 0 ? 1 : \cnt.left ));
    if (was_reset) assert (ready_o && held == 0);
    if (was_idle) assert (held == before);
  end
`endif

endmodule

`default_nettype wire
