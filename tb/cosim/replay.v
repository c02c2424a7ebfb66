// SPDX-License-Identifier: Apache-2.0
// Replays writes and their expected results on an exported device in Icarus. device.vh and vectors.txt are those of
// replay_vectors: the device's ports, and a line "TRAILING LEVEL RESULTS" of binary numbers for each write, namely the
// data whose strobe writes by its trailing edge, the other data, and what the results become. +stuck_PORT holds that
// output at 0, so that the bench can be seen to notice.
`timescale 1ns / 1ps
`include "device.vh"

module replay;
  reg clk = 1, rst_n = 0, level = 0, trailing = 0;
  reg [`TRAILING_BITS-1:0] trailing_data, next_trailing_data;
  reg [`LEVEL_BITS-1:0] level_data, next_level_data;
  reg [`RESULT_BITS-1:0] expected, next_expected;
  wire [`RESULT_BITS-1:0] results;
  wire valid;

  `DEVICE

  always #5 clk = ~clk;

  integer file, fields, writes = 0, compared = 0, failures = 0;

  // The results belong to the write before when valid rises.
  always @(posedge valid)
    if (writes > 0) begin
      compared = compared + 1;
      if (results !== expected) begin
        failures = failures + 1;
        $display("write %0d, %b %b: got %b, expected %b", writes, trailing_data, level_data, results, expected);
      end
    end

  initial begin
    `STUCK
  end

  initial begin
    file = $fopen("vectors.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    fields = $fscanf(file, "%b %b %b", next_trailing_data, next_level_data, next_expected);
    while (fields == 3) begin
      @(negedge clk) level = 0;
      trailing_data = next_trailing_data;
      trailing = 1;
      @(negedge clk) trailing = 0;
      level_data = next_level_data;
      expected = next_expected;
      level = 1;
      writes = writes + 1;
      fields = $fscanf(file, "%b %b %b", next_trailing_data, next_level_data, next_expected);
    end
    @(negedge clk) trailing = 1;
    @(posedge clk) $display("%0d writes replayed, %0d compared, %0d differ", writes, compared, failures);
    $finish(0);
  end
endmodule
