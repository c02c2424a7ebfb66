// SPDX-License-Identifier: Apache-2.0
// An exported device in Icarus, whose registers begin as X: after the reset no output is X, whatever the data inputs are while
// their strobes are at zero, and 0 or 1 data written as the device says leave none behind. device.vh and vectors.txt are
// those of replay_vectors. +no_reset leaves the reset out, so that the bench can be seen to notice.
`timescale 1ns / 1ps
`include "device.vh"

module four_state;
  reg clk = 1, rst_n, level = 0, trailing = 0;
  reg [`TRAILING_BITS-1:0] trailing_data, next_trailing_data;
  reg [`LEVEL_BITS-1:0] level_data, next_level_data;
  reg [`RESULT_BITS-1:0] next_expected;
  wire [`RESULT_BITS-1:0] results;
  wire valid;

  `DEVICE

  always #5 clk = ~clk;

  integer file, fields, writes = 0, looked = 0, unknown = 0;
  reg has_reset = 0;

  // Half of half a period after each edge of clk.
  always @(clk)
    if (has_reset) begin
      #2.5 looked = looked + 1;
      if (^{results, valid} === 1'bx) begin
        unknown = unknown + 1;
        if (unknown <= 10) $display("%0t: %b %b", $time, results, valid);
      end
    end

  initial begin
    file = $fopen("vectors.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = $test$plusargs("no_reset") ? 1 : 0;
    @(posedge clk) has_reset = 1;
    @(negedge clk) rst_n = 1;
    repeat (3) @(negedge clk);
    fields = $fscanf(file, "%b %b %b", next_trailing_data, next_level_data, next_expected);
    while (fields == 3) begin
      @(negedge clk) trailing = 1;
      trailing_data = next_trailing_data;
      @(negedge clk) trailing = 0;
      level = 1;
      level_data = next_level_data;
      @(negedge clk) level = 0;
      trailing_data = {`TRAILING_BITS{1'bx}};
      level_data = {`LEVEL_BITS{1'bx}};
      writes = writes + 1;
      fields = $fscanf(file, "%b %b %b", next_trailing_data, next_level_data, next_expected);
    end
    @(negedge clk) $display("%0d writes, outputs looked at %0d times, X %0d times", writes, looked, unknown);
    $finish(0);
  end
endmodule
