// SPDX-License-Identifier: Apache-2.0
// An exported device that takes a row by start and ready, in Icarus, whose registers begin as X: after the reset ready and valid
// are never X, and no result is while valid is at one, whatever the data inputs are while start is at zero. device.vh and
// vectors.txt are those of replay_vectors. +no_reset leaves the reset out, so that the bench can be seen to notice.
`timescale 1ns / 1ps
`include "device.vh"

module four_state;
  reg clk = 1, rst_n, start = 0;
  reg [`LEVEL_BITS-1:0] level_data, next_level_data;
  wire [`RESULT_BITS-1:0] results;
  wire valid, ready;

  `DEVICE

  always #5 clk = ~clk;

  integer file, fields, rows = 0, delivered = 0, looked = 0, unknown = 0, beside = 0, waited = 0;
  reg has_reset = 0;

  // Half of half a period after each edge of clk.
  always @(clk)
    if (has_reset) begin
      #2.5 looked = looked + 1;
      if (^{ready, valid} === 1'bx || valid !== 0 && ^results === 1'bx) begin
        unknown = unknown + 1;
        if (unknown <= 10) $display("%0t: %b %b %b", $time, ready, valid, results);
      end else if (^results === 1'bx) beside = beside + 1;
    end

  always @(posedge clk)
    if (has_reset && valid === 1) begin
      delivered = delivered + 1;
      waited = 0;
    end

  initial begin
    file = $fopen("vectors.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = $test$plusargs("no_reset") ? 1 : 0;
    @(posedge clk) has_reset = 1;
    @(negedge clk) rst_n = 1;
    repeat (3) @(negedge clk);
    fields = $fscanf(file, "%b", next_level_data);
    // A device that does nothing for a thousand cycles is at the end of its rows, or was not reset.
    while (waited < 1000) begin
      @(negedge clk) start = ready !== 0 && fields == 1;
      level_data = {`LEVEL_BITS{1'bx}};
      waited = waited + 1;
      if (start) begin
        waited = 0;
        level_data = next_level_data;
        rows = rows + 1;
        fields = $fscanf(file, "%b", next_level_data);
      end
    end
    $display("results X %0d times while valid was at zero", beside);
    $display("%0d rows, %0d delivered, outputs looked at %0d times, X %0d times", rows, delivered, looked,
             unknown);
    $finish(0);
  end
endmodule
