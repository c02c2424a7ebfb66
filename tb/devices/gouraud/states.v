// SPDX-License-Identifier: Apache-2.0
// What holds for the exported Gouraud interpolator after its first reset, whatever its inputs are: see tb/cosim/states.sh. A port is
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
    input wire [6:0] \control.steps_left ,
    input wire [10:0] \control.pixels_left ,
    input wire [F:0] \rg_digits.held
);

  wire [6:0] steps = \control.steps_left ;
  wire [10:0] pixels = \control.pixels_left ;

  // range: of the two counters; the digits that are still to come are the uppermost ones, one for each step
  always @* begin
    assert (steps <= F && pixels <= 1024);
    assert (steps == 0 || pixels != 0);
    assert (ready_o == (pixels == 0));
    assert (valid_o == (steps == 0 && pixels != 0));
    assert ((\rg_digits.held & ~({F + 1{1'b1}} << (F + 1 - steps))) == 0);
  end

`ifdef OVER_TIME
  // hold: the outputs keep their values while there is no line and while it is prepared; protocol: F + 1 edges after the one
  // that took a line valid_o becomes one, for length + 1 cycles, and it is one at no other time
  reg was_reset = 0, was_still = 0;
  reg [6:0] prepared = 0;
  reg [10:0] owed = 0;
  reg [23:0] before = 0;
  always @(posedge clk) begin
    was_reset <= !rst_n;
    was_still <= rst_n && !valid_o && !(start_i && ready_o);
    before <= {r_o, g_o, b_o};
    if (!rst_n) begin
      prepared <= 0;
      owed <= 0;
    end else if (start_i && ready_o) begin
      prepared <= 1;
      owed <= length_i + 1;
    end else if (owed != 0) begin
      if (prepared <= F) prepared <= prepared + 1;
      else owed <= owed - 1;
    end
  end
  always @* begin
    assert (owed == pixels);
    assert (owed == 0 || prepared == F + 1 - steps);
    assert (valid_o == (owed != 0 && prepared == F + 1));
    if (was_reset) assert (ready_o && {r_o, g_o, b_o} == 0);
    if (was_still) assert ({r_o, g_o, b_o} == before);
  end
`endif

endmodule

`default_nettype wire
