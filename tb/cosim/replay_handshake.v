// SPDX-License-Identifier: Apache-2.0
// Replays rows and their expected results in Icarus on an exported device that takes a row by start and ready. The files
// are those of replay_vectors: device.vh with the device's ports, vectors.txt with a binary number for the data of each
// row, results.txt with one for each row of results. +stuck_PORT holds that output at 0, so that the bench can be seen to
// notice.
`timescale 1ns / 1ps
`include "device.vh"

module replay;
  reg clk = 1, rst_n = 0, start = 0;
  reg [`LEVEL_BITS-1:0] level_data, next_level_data;
  reg [`RESULT_BITS-1:0] expected;
  wire [`RESULT_BITS-1:0] results;
  wire valid, ready;

  `DEVICE

  always #5 clk = ~clk;

  integer file, results_file, fields, rows = 0, compared = 0, failures = 0, waited = 0;

  // A rising edge of clk that sees valid at one delivers a row.
  always @(posedge clk)
    if (rst_n && valid !== 0) begin
      if ($fscanf(results_file, "%b", expected) != 1 || results !== expected) begin
        failures = failures + 1;
        if (failures <= 10) $display("result %0d: got %b, expected %b", compared, results, expected);
      end
      compared = compared + 1;
      waited = 0;
    end

  initial begin
    `STUCK
  end

  initial begin
    file = $fopen("vectors.txt", "r");
    results_file = $fopen("results.txt", "r");
    repeat (2) @(negedge clk);
    rst_n = 1;
    fields = $fscanf(file, "%b", next_level_data);
    // A device that does nothing for a thousand cycles is at the end of its rows, or stuck.
    while (waited < 1000) begin
      @(negedge clk) start = ready === 1 && fields == 1;
      waited = waited + 1;
      if (start) begin
        waited = 0;
        level_data = next_level_data;
        rows = rows + 1;
        fields = $fscanf(file, "%b", next_level_data);
      end
    end
    // What is expected beyond is missing.
    while ($fscanf(results_file, "%b", expected) == 1) failures = failures + 1;
    $display("%0d writes replayed, %0d compared, %0d differ", rows, compared, failures);
    $finish(0);
  end
endmodule
