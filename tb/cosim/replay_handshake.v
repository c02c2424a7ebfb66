// SPDX-License-Identifier: Apache-2.0
// Replays rows and their expected results in Icarus on an exported device that takes a row by start and ready. device.vh
// and vectors.txt are those of replay_vectors: the device's ports, and a line "DATA RESULTS" of binary numbers for each
// row. +stuck_PORT holds that output at 0, so that the bench can be seen to notice.
`timescale 1ns / 1ps
`include "device.vh"

module replay;
  reg clk = 1, rst_n = 0, start = 0;
  reg [`LEVEL_BITS-1:0] level_data, next_level_data;
  reg [`RESULT_BITS-1:0] next_expected;
  reg [`RESULT_BITS-1:0] expected [0:4095];  // of the rows taken
  wire [`RESULT_BITS-1:0] results;
  wire valid, ready;

  `DEVICE

  always #5 clk = ~clk;

  integer file, fields, writes = 0, compared = 0, failures = 0, waited = 0;

  // A rising edge of clk that sees valid at one delivers the results of the oldest row.
  always @(posedge clk)
    if (rst_n && valid !== 0) begin
      if (results !== expected[compared % 4096]) begin
        failures = failures + 1;
        $display("row %0d: got %b, expected %b", compared, results, expected[compared % 4096]);
      end
      compared = compared + 1;
    end

  initial begin
    `STUCK
  end

  initial begin
    file = $fopen("vectors.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    fields = $fscanf(file, "%b %b", next_level_data, next_expected);
    // A device that does not get ready any more is left after a thousand cycles.
    while (fields == 2 && waited < 1000) begin
      @(negedge clk) start = ready === 1;
      waited = waited + 1;
      if (start) begin
        waited = 0;
        level_data = next_level_data;
        expected[writes % 4096] = next_expected;
        writes = writes + 1;
        fields = $fscanf(file, "%b %b", next_level_data, next_expected);
      end
    end
    @(negedge clk) start = 0;
    repeat (1000) @(negedge clk);
    $display("%0d writes replayed, %0d compared, %0d differ", writes, compared, failures);
    $finish(0);
  end
endmodule
