// SPDX-License-Identifier: Apache-2.0
// Host of a serial wrapper, module DUT: sends the file +vectors=FILE through the line and writes what comes back to
// +answers=FILE. The next line goes out when the answer of the one before is complete. MAPPED: DUT is a netlist, whose
// divisor is the preset.
`timescale 1ns / 1ps
module serial_bench;
`ifdef MAPPED
  localparam integer DIVISOR = 104;
`else
  localparam integer DIVISOR = 8;
`endif
  localparam integer PATIENCE = 1000 * DIVISOR;  // clocks between two characters

  reg clk = 0;
  always #5 clk = !clk;

  reg rx = 1;
  wire tx;
`ifdef MAPPED
  `DUT dut (.clk(clk), .rx_i(rx), .tx_o(tx));
`else
  `DUT #(.DIVISOR(DIVISOR)) dut (.clk(clk), .rx_i(rx), .tx_o(tx));
`endif

  reg [8*1024-1:0] path;
  integer vectors, answers, symbol, index, waited, lines_out, lines_in;
  reg [7:0] got;

  task send(input [7:0] character);
    begin
      rx = 0;
      repeat (DIVISOR) @(negedge clk);
      for (index = 0; index < 8; index = index + 1) begin
        rx = character[index];
        repeat (DIVISOR) @(negedge clk);
      end
      rx = 1;
      repeat (DIVISOR) @(negedge clk);
    end
  endtask

  integer place;
  initial begin
    lines_in = 0;
    forever begin
      @(negedge tx);
      repeat (DIVISOR / 2) @(negedge clk);
      if (tx === 1'b0) begin
        for (place = 0; place < 8; place = place + 1) begin
          repeat (DIVISOR) @(negedge clk);
          got[place] = tx;
        end
        repeat (DIVISOR) @(negedge clk);
        if (tx !== 1'b1) begin
          $display("a character without a stop bit");
          $finish(1);
        end
        $fwrite(answers, "%c", got);
        waited = 0;
        if (got == 8'h0a) lines_in = lines_in + 1;
      end
    end
  end

  initial begin
    if (!$value$plusargs("vectors=%s", path)) path = "vectors.txt";
    vectors = $fopen(path, "r");
    if (!$value$plusargs("answers=%s", path)) path = "answers.txt";
    answers = $fopen(path, "w");
    if (vectors == 0 || answers == 0) begin
      $display("cannot read the vectors or write the answers");
      $finish(1);
    end
    lines_out = 0;
    repeat (20 * DIVISOR) @(negedge clk);
    symbol = $fgetc(vectors);
    while (symbol != -1) begin
      send(symbol[7:0]);
      if (symbol == 10) begin
        lines_out = lines_out + 1;
        waited = 0;
        while (lines_in != lines_out) begin
          @(negedge clk) waited = waited + 1;
          if (waited > PATIENCE) begin
            $display("no answer to line %0d", lines_out);
            $finish(1);
          end
        end
      end
      symbol = $fgetc(vectors);
    end
    $fclose(answers);
    $finish(0);
  end
endmodule
