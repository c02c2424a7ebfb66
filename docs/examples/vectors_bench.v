// SPDX-License-Identifier: Apache-2.0
// Puts the vectors of `blysk vectors` into a device with the registers of UA 60553 and writes them back with the outputs
// appended, for `blysk check`. DEVICE is the device's module, F the fraction bits of its cosine:
//
//   blysk vectors --format q12 --output vectors.txt
//   iverilog -g2001 -DDEVICE=blysk_quadratic_q12 -DF=12 -o bench vectors_bench.v DEVICE_FILES...
//   vvp bench +vectors=vectors.txt +answers=answers.txt
//   blysk check --format q12 --answers answers.txt
`timescale 1ns / 1ps
`ifndef SETTLES
`define SETTLES 0  // clock cycles more that a write needs: 1 for a device with a clocked memory
`endif
module vectors_bench;
  reg clk, rst_n, cos_we, level_we;
  reg [9:0] n;
  reg [`F:0] cos;
  reg [7:0] r, g, b;
  // What the vector says.
  reg [9:0] n_given;
  reg [`F:0] cos_given;
  reg [7:0] r_given, g_given, b_given;
  wire [`F+7:0] r_out, g_out, b_out;
  wire valid;

  `DEVICE device (.clk(clk), .rst_n(rst_n), .n_i(n), .n_we_i(level_we), .cos_i(cos), .cos_we_i(cos_we),
                  .r_i(r), .r_we_i(level_we), .g_i(g), .g_we_i(level_we), .b_i(b), .b_we_i(level_we),
                  .r_o(r_out), .g_o(g_out), .b_o(b_out), .valid_o(valid));

  always #5 clk = !clk;

  reg [8*1024-1:0] name, header;
  integer vectors, answers, taken;

  task put;  // at a falling edge of clk; takes two cycles. Nothing is there but when a register takes it.
    begin
      {n, cos, r, g, b} = {n_given, ~cos_given, r_given, g_given, b_given};
      level_we = 1;
      cos_we = 1;
      @(negedge clk) level_we = 0;  // registers 1, 3, 4, 5 have their values
      cos_we = 0;
      {n, cos, r, g, b} = {~n_given, cos_given, ~r_given, ~g_given, ~b_given};
      @(negedge clk) cos = ~cos_given;  // and register 2, which takes it when its strobe has gone down
    end
  endtask

  initial begin
    if (!$value$plusargs("vectors=%s", name)) name = "vectors.txt";
    vectors = $fopen(name, "r");
    if (!$value$plusargs("answers=%s", name)) name = "answers.txt";
    answers = $fopen(name, "w");
    taken = $fgets(header, vectors);
    $fwrite(answers, "%0s", header);
    clk = 0;
    rst_n = 0;
    level_we = 0;
    cos_we = 0;
    {n, cos, r, g, b} = 0;
    @(negedge clk);
    @(negedge clk) rst_n = 1;
    taken = $fscanf(vectors, "%h %h %h %h %h", n_given, cos_given, r_given, g_given, b_given);
    while (taken == 5) begin
      put;
      repeat (`SETTLES) @(negedge clk);
      $fdisplay(answers, "%h %h %h %h %h %h %h %h", n_given, cos_given, r_given, g_given, b_given, r_out, g_out, b_out);
      taken = $fscanf(vectors, "%h %h %h %h %h", n_given, cos_given, r_given, g_given, b_given);
    end
    $fclose(answers);
    $finish(0);
  end
endmodule
